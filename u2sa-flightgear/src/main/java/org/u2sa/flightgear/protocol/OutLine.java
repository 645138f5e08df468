package org.u2sa.flightgear.protocol;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** One line that FlightGear sent: a value of each {@link OutField}, in U2SA's units. */
public final class OutLine {
  /**
   * Value of {@link OutField#HEIGHT} for a Cessna 172 standing on its wheels: 4.05 ft [m].
   * Measured, as is the reference point's height above the runway's own elevation, 4.38 ft at PHNL
   * and 4.43 ft at BIKF (docs/flightgear.md).
   */
  public static final double STANDING_M = Unit.FOOT.toUsed(4.05);

  private static final double LOWEST_ALTITUDE_FT = -1_000.0; // −9999 before the flight model runs
  private static final OutField[] FIELDS = OutField.values();

  private final double[] onTheLine;

  private OutLine(double[] onTheLine) {
    this.onTheLine = onTheLine;
  }

  /**
   * Reads a line without its line end.
   *
   * @throws MalformedLineException if a field is missing, extra, not a finite number or impossible;
   *     the whole line is then rejected
   */
  public static OutLine parse(String line) throws MalformedLineException {
    List<String> parts = PropertyNumbers.split(line);
    if (parts.size() != FIELDS.length) {
      throw new MalformedLineException(
          "\""
              + PropertyNumbers.shown(line)
              + "\" has "
              + parts.size()
              + " fields, expected "
              + FIELDS.length);
    }
    double[] values = new double[FIELDS.length];
    for (OutField field : FIELDS) {
      values[field.ordinal()] = PropertyNumbers.parse(field.node(), parts.get(field.ordinal()));
    }
    OutLine read = new OutLine(values);
    if (!read.isBeforeFlight()) {
      read.requirePlausible();
    }
    return read;
  }

  /**
   * Formats a line.
   *
   * @param values in U2SA's units; omitted fields are 0
   * @throws IllegalArgumentException if a value is not finite
   */
  public static OutLine of(Map<OutField, Double> values) {
    double[] onTheLine = new double[FIELDS.length];
    new EnumMap<>(values)
        .forEach(
            (field, value) -> {
              if (!Double.isFinite(value)) {
                throw new IllegalArgumentException(
                    field + ": " + value + " is not a finite number");
              }
              onTheLine[field.ordinal()] = field.unit().toLine(value);
            });
    return new OutLine(onTheLine);
  }

  /** Whether it precedes FlightGear's flight model: its values are then meaningless. */
  public boolean isBeforeFlight() {
    return onTheLine[OutField.ELAPSED.ordinal()] <= 0.0
        || onTheLine[OutField.ALTITUDE.ordinal()] < LOWEST_ALTITUDE_FT;
  }

  /** The value in U2SA's unit. */
  public double get(OutField field) {
    return field.unit().toUsed(onTheLine[field.ordinal()]);
  }

  /** Whether a field that is 0 or 1 is 1. */
  public boolean isSet(OutField field) {
    return onTheLine[field.ordinal()] > 0.5;
  }

  /** The line as FlightGear sends it, without its line end. */
  public String format() {
    StringBuilder line = new StringBuilder();
    for (double value : onTheLine) {
      line.append(line.length() == 0 ? "" : ",")
          .append(String.format(Locale.ROOT, ProtocolFiles.FORMAT, value));
    }
    return line.toString();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof OutLine line && Arrays.equals(onTheLine, line.onTheLine);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(onTheLine);
  }

  @Override
  public String toString() {
    return format();
  }

  private void requirePlausible() throws MalformedLineException {
    for (OutField field : FIELDS) {
      double value = onTheLine[field.ordinal()];
      if (!field.isPlausible(value)) {
        throw new MalformedLineException(
            field.node() + ": " + value + " is outside " + field.range());
      }
    }
  }
}
