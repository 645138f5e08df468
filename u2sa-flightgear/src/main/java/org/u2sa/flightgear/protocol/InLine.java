package org.u2sa.flightgear.protocol;

import java.util.List;
import java.util.Locale;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * A line sent to FlightGear: the controls and the line number.
 *
 * <p>{@link ControlInputs} holds only finite numbers within their ranges, so a line cannot carry a
 * "nan", which would corrupt FlightGear's flight model permanently.
 *
 * @param controls all controls
 * @param count number of the line, 0…{@value #LAST_COUNT}; FlightGear echoes it
 */
public record InLine(ControlInputs controls, long count) {
  /** Highest number of a line; after it comes 1. */
  public static final long LAST_COUNT = 999_999;

  /**
   * @throws IllegalArgumentException if the count is outside its range
   */
  public InLine {
    if (count < 0 || count > LAST_COUNT) {
      throw new IllegalArgumentException("count: " + count + " is outside 0…" + LAST_COUNT);
    }
  }

  /** Before the first line: neutral controls, count 0. */
  public static InLine nothing() {
    return new InLine(ControlInputs.neutral(), 0);
  }

  /** The next line, which sets other controls. */
  public InLine next(ControlInputs newControls) {
    return new InLine(newControls, count == LAST_COUNT ? 1 : count + 1);
  }

  /** The line as FlightGear reads it, without its line end. */
  public String format() {
    StringBuilder line = new StringBuilder();
    for (InField field : InField.values()) {
      if (field == InField.COUNT) {
        line.append(count);
      } else {
        line.append(String.format(Locale.ROOT, "%.6f,", field.of(controls)));
      }
    }
    return line.toString();
  }

  /**
   * Parses a line as FlightGear does: a shorter line sets only its own fields, text that is not a
   * number counts as 0, and extra fields are ignored.
   *
   * @throws MalformedLineException if a field is "nan" or "inf": FlightGear would accept it and
   *     never recover
   */
  public InLine after(String line) throws MalformedLineException {
    List<String> parts = PropertyNumbers.split(line);
    InField[] fields = InField.values();
    double[] values = new double[fields.length];
    for (InField field : fields) {
      values[field.ordinal()] =
          field.ordinal() < parts.size()
              ? told(field, parts.get(field.ordinal()))
              : field == InField.COUNT ? count : field.of(controls);
    }
    ControlInputs now =
        ControlInputs.limited(
            values[InField.AILERON.ordinal()],
            values[InField.ELEVATOR.ordinal()],
            values[InField.RUDDER.ordinal()],
            values[InField.THROTTLE.ordinal()],
            values[InField.MIXTURE.ordinal()],
            values[InField.FLAPS.ordinal()],
            values[InField.BRAKE_LEFT.ordinal()],
            values[InField.BRAKE_RIGHT.ordinal()]);
    long counted = (long) values[InField.COUNT.ordinal()];
    return new InLine(now, Math.max(0, Math.min(LAST_COUNT, counted)));
  }

  private static double told(InField field, String text) throws MalformedLineException {
    String lower = text.trim().toLowerCase(Locale.ROOT);
    if (lower.contains("nan") || lower.contains("inf")) {
      throw new MalformedLineException(
          field.node()
              + ": \""
              + PropertyNumbers.shown(text)
              + "\" would corrupt the flight model");
    }
    return PropertyNumbers.isNumber(lower) ? Double.parseDouble(lower) : 0.0;
  }
}
