# Tribonacci word
m = WordMorphism('0->01,1->02,2->0')
m('0', 5)
