#include "oracle/boxes.hpp"

#include <cmath>
#include <ostream>

namespace algae::oracle {

namespace {

constexpr double slack = 1e-9;

/// The planes of a cut between two places, both ends among them; none if the sizes do not fit.
std::vector<double> planes(double low, double high, const CutRule::Cut& cut) {
    std::vector<double> out{low};
    double fixed = 0, shares = 0;
    for (const auto& size : cut.sizes) (size.share ? shares : fixed) += size.value;
    const double rest = (high - low) - fixed;
    if (rest < -slack || (shares > 0 && rest < slack)) return {};
    for (const auto& size : cut.sizes)
        out.push_back(out.back() + (size.share ? rest / shares * size.value : size.value));
    return out;
}

bool cut(const CutRule& rule, const CutBox& box, std::size_t depth, std::vector<CutBox>& out) {
    if (depth == rule.cuts.size()) {
        out.push_back(box);
        return true;
    }
    const std::size_t axis = static_cast<std::size_t>(rule.cuts[depth].axis - 'X');
    std::vector<double> at;
    if (rule.repeated) {
        const double extent = box.high[axis] - box.low[axis];
        const int count = static_cast<int>(std::floor(extent / rule.repeated + slack));
        if (count < 1) return false;
        for (int i = 0; i <= count; ++i) at.push_back(box.low[axis] + extent * i / count);
    } else {
        at = planes(box.low[axis], box.high[axis], rule.cuts[depth]);
        if (at.empty()) return false;
    }
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        CutBox part = box;
        part.low[axis] = at[i];
        part.high[axis] = at[i + 1];
        if (!cut(rule, part, depth + 1, out)) return false;
    }
    return true;
}

}  // namespace

bool cut_one_by_one(const std::vector<CutRule>& rules, std::vector<CutBox>& boxes) {
    for (;;) {
        std::size_t last = boxes.size();
        const CutRule* found = nullptr;
        while (!found && last-- > 0)
            for (const CutRule& rule : rules)
                if (rule.letter == boxes[last].letter) found = &rule;
        if (!found) return true;
        std::vector<CutBox> parts;
        if (!cut(*found, boxes[last], 0, parts)) return false;
        for (std::size_t i = 0; i < parts.size(); ++i)
            parts[i].letter = found->parts[found->parts.size() == 1 ? 0 : i];
        boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(last));
        boxes.insert(boxes.begin() + static_cast<std::ptrdiff_t>(last), parts.begin(), parts.end());
    }
}

bool further_than(const std::vector<CutBox>& boxes, std::size_t box, std::size_t axis, char letter,
                  int bound) {
    for (std::size_t other = 0; other < boxes.size(); ++other) {
        if (other == box || boxes[other].letter != letter) continue;
        for (int moved = -bound; moved <= bound; ++moved)
            if (boxes[box].low[axis] + moved <= boxes[other].high[axis] &&
                boxes[other].low[axis] <= boxes[box].high[axis] + moved)
                return false;
    }
    return true;
}

std::string written(const CutRule& rule) {
    std::string text = std::string(1, rule.letter) + " -> ";
    if (rule.cuts.empty()) return text + "I(" + rule.parts + ")";
    if (rule.repeated)
        return text + "repeat(" + rule.cuts[0].axis + ", " + std::to_string(rule.repeated) + "){ " +
               rule.parts + " }";
    text += "div(";
    for (const auto& cut : rule.cuts) text += cut.axis;
    for (std::size_t i = 0; i < rule.cuts.size(); ++i)
        for (std::size_t k = 0; k < rule.cuts[i].sizes.size(); ++k)
            text += (i > 0 && k == 0 ? " : " : ", ") + std::to_string(rule.cuts[i].sizes[k].value) +
                    (rule.cuts[i].sizes[k].share ? "r" : "");
    text += "){";
    for (const char part : rule.parts) text += std::string(" ") + part;
    return text + " }";
}

std::ostream& operator<<(std::ostream& out, const CutRule& rule) { return out << written(rule); }

}  // namespace algae::oracle
