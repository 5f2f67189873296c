"""From wrong answers to mistakes: which explain one answer, and which return from problem to problem."""
