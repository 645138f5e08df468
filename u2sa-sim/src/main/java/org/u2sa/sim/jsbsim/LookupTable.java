package org.u2sa.sim.jsbsim;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.u2sa.interfaces.xml.XmlElement;

/** A JSBSim table over one or two variables: linear between its points, constant beyond them. */
final class LookupTable {
  private final double[] rows;
  private final double[] columns;
  private final double[][] values; // by row and column

  private LookupTable(double[] rows, double[] columns, double[][] values) {
    this.rows = rows;
    this.columns = columns;
    this.values = values;
  }

  /** Reads the only {@code tableData} of a table: two columns, or a matrix below a row of keys. */
  static LookupTable read(XmlElement table) {
    XmlElement data = table.requiredChild("tableData");
    if (data.optionalAttribute("breakPoint").isPresent()) {
      throw data.error("a table over three variables; expected one or two");
    }
    List<double[]> lines =
        data.text()
            .lines()
            .map(String::trim)
            .filter(line -> !line.isEmpty())
            .map(line -> line(data, line))
            .collect(Collectors.toList());
    boolean isMatrix = lines.size() > 1 && lines.get(1).length == lines.get(0).length + 1;
    double[] columns = isMatrix ? lines.get(0) : new double[] {0.0};
    List<double[]> body = isMatrix ? lines.subList(1, lines.size()) : lines;
    for (double[] line : body) {
      if (line.length != columns.length + 1) {
        throw data.error("a row of " + line.length + " numbers; expected " + (columns.length + 1));
      }
    }
    if (body.isEmpty()) {
      throw data.error("is empty; expected rows of numbers");
    }
    return new LookupTable(
        ascending(data, body.stream().mapToDouble(line -> line[0]).toArray()),
        ascending(data, columns),
        body.stream()
            .map(line -> Arrays.copyOfRange(line, 1, line.length))
            .toArray(double[][]::new));
  }

  private static double[] line(XmlElement data, String line) {
    return Arrays.stream(line.split("[\\s,]+"))
        .mapToDouble(each -> UnitNumbers.plain(data, each))
        .toArray();
  }

  private static double[] ascending(XmlElement data, double[] keys) {
    for (int i = 1; i < keys.length; i++) {
      if (!(keys[i] > keys[i - 1])) {
        throw data.error("key " + keys[i] + " follows " + keys[i - 1] + "; expected a larger one");
      }
    }
    return keys;
  }

  boolean isMatrix() {
    return columns.length > 1;
  }

  double at(double row, double column) {
    int r = above(rows, row);
    int c = above(columns, column);
    double along = share(rows, r, row);
    double across = share(columns, c, column);
    double left = between(values[before(r)][before(c)], values[r][before(c)], along);
    double right = between(values[before(r)][c], values[r][c], along);
    return between(left, right, across);
  }

  private static int before(int index) {
    return Math.max(0, index - 1);
  }

  private static double between(double a, double b, double share) {
    return a + share * (b - a);
  }

  /** Index of the key at the upper end of the interval that holds a value. */
  private static int above(double[] keys, double value) {
    int i = Math.min(1, keys.length - 1);
    while (i < keys.length - 1 && keys[i] < value) {
      i++;
    }
    return i;
  }

  private static double share(double[] keys, int upper, double value) {
    if (upper == 0) {
      return 1.0;
    }
    double share = (value - keys[upper - 1]) / (keys[upper] - keys[upper - 1]);
    return Math.max(0.0, Math.min(1.0, share));
  }
}
