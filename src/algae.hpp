#pragma once
// The faces that most programs need. A program that draws adds <algae/render.hpp>, one that converts files of other
// programs <algae/exchange.hpp>.

#include "automatic/automatic.hpp"
#include "combinatorics/combinatorics.hpp"
#include "dimension/dimension.hpp"
#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "language/language.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"
#include "verify/verify.hpp"
#include "word/word.hpp"
