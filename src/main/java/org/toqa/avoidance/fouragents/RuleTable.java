package org.toqa.avoidance.fouragents;

import java.util.Arrays;
import java.util.List;

/**
 * A zero-order Takagi-Sugeno controller: one rule for each combination of terms, whose consequents
 * are numbers.
 *
 * <p>{@code w_k = product over the inputs of the degree of rule k's term; y = sum w_k c_k / sum
 * w_k}. The terms of each {@link Partition} add up to 1, and so do the w_k: the quotient is left
 * out. (T. Takagi, M. Sugeno, "Fuzzy identification of systems and its applications to modeling and
 * control", 1985.)
 */
final class RuleTable {
  private final List<Partition> inputs;
  private final double[][] consequents;

  /**
   * @param inputs the variables, the last one varies fastest over the rules
   * @param consequents the outputs of each rule, in that order
   */
  RuleTable(List<Partition> inputs, double[][] consequents) {
    this.inputs = List.copyOf(inputs);
    this.consequents = Arrays.stream(consequents).map(double[]::clone).toArray(double[][]::new);
    int rules = inputs.stream().mapToInt(Partition::size).reduce(1, (a, b) -> a * b);
    if (rules != consequents.length) {
      throw new IllegalArgumentException(
          "A table of " + rules + " rules has " + consequents.length + " consequents.");
    }
  }

  int ruleCount() {
    return consequents.length;
  }

  /** The outputs for crisp inputs, in the order of the partitions. */
  double[] outputs(double... values) {
    double[] sum = new double[consequents[0].length];
    add(sum, values, 0, 0, 1);
    return sum;
  }

  /** Adds the rules below a node of the tree of terms; those of weight 0 are cut off. */
  private void add(double[] sum, double[] values, int input, int first, double weight) {
    if (input == inputs.size()) {
      for (int i = 0; i < sum.length; i++) {
        sum[i] += weight * consequents[first][i];
      }
      return;
    }
    Partition partition = inputs.get(input);
    for (int term = 0; term < partition.size(); term++) {
      double degree = partition.degree(term, values[input]);
      if (degree > 0) {
        add(sum, values, input + 1, first * partition.size() + term, weight * degree);
      }
    }
  }
}
