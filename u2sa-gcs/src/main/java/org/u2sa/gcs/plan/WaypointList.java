package org.u2sa.gcs.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.BadInputException;

/**
 * The text format {@code QGC WPL 110} of QGroundControl, Mission Planner and MAVProxy: one line per
 * item, with twelve columns separated by tabs; item 0 is the home.
 */
public final class WaypointList {
  private static final String HEADER = "QGC WPL 110";
  private static final int COLUMNS = 12;
  private static final int FIRST_PARAMETER = 4;
  private static final int LAST_COLUMN = COLUMNS - 1;

  private final String origin;
  private int number; // of the line

  private WaypointList(String origin) {
    this.origin = origin;
  }

  /** Whether a text is in this format. */
  public static boolean isOne(String text) {
    return text.startsWith("QGC WPL");
  }

  /**
   * Reads a list.
   *
   * @param origin name of the file, for errors
   * @throws BadInputException naming line and column
   */
  public static StationPlan read(String origin, String text) {
    return new WaypointList(origin).plan(text.split("\\R"));
  }

  private StationPlan plan(String[] lines) {
    number = 1;
    if (!lines[0].trim().equals(HEADER)) {
      throw wrong("\"" + lines[0] + "\": expected " + HEADER);
    }
    List<PlanItem> items = new ArrayList<>();
    for (int i = 1; i < lines.length; i++) {
      number = i + 1;
      if (!lines[i].isBlank() && !lines[i].startsWith("#")) {
        items.add(item(lines[i].trim().split("\\s+")));
        if (items.get(items.size() - 1).id() != items.size() - 1) {
          throw wrong("index: expected " + (items.size() - 1));
        }
      }
    }
    if (items.isEmpty()) {
      throw wrong("no items; expected the home as item 0");
    }
    return new StationPlan(home(items.get(0)), items.subList(1, items.size()), List.of());
  }

  private Optional<StationPlan.Place> home(PlanItem item) {
    double latitude = item.parameter(5);
    double longitude = item.parameter(6);
    double altitude = item.parameter(7);
    if (latitude == 0.0 && longitude == 0.0) {
      return Optional.empty();
    }
    if (!(Math.abs(latitude) <= 90.0 && Math.abs(longitude) <= 180.0)) {
      throw new BadInputException(
          origin + ": item 0: " + latitude + ", " + longitude + " is not on the earth");
    }
    boolean hasAltitude = Double.isFinite(altitude);
    return Optional.of(
        new StationPlan.Place(
            longitude,
            latitude,
            hasAltitude ? OptionalDouble.of(altitude) : OptionalDouble.empty()));
  }

  private PlanItem item(String[] columns) {
    if (columns.length != COLUMNS) {
      throw wrong(columns.length + " columns; expected " + COLUMNS);
    }
    List<Double> parameters = new ArrayList<>();
    for (int i = FIRST_PARAMETER; i < LAST_COLUMN; i++) {
      parameters.add(number(columns[i], i));
    }
    boolean goesOn = whole(columns[LAST_COLUMN], LAST_COLUMN) != 0;
    return new PlanItem(
            whole(columns[3], 3), whole(columns[2], 2), parameters, goesOn, whole(columns[0], 0))
        .withoutHeading0();
  }

  private double number(String text, int column) {
    String lower = text.toLowerCase(Locale.ROOT);
    if (lower.matches("[+-]?nan")) {
      return Double.NaN;
    }
    if (!lower.matches("[+-]?(\\d+\\.?\\d*|\\.\\d+)(e[+-]?\\d{1,3})?")) {
      throw wrong("column " + (column + 1) + " \"" + text + "\": expected a number");
    }
    return Double.parseDouble(lower);
  }

  private int whole(String text, int column) {
    if (!text.matches("\\d{1,6}")) {
      throw wrong("column " + (column + 1) + " \"" + text + "\": expected a whole number");
    }
    return Integer.parseInt(text);
  }

  private BadInputException wrong(String what) {
    return new BadInputException(origin + ", line " + number + ": " + what);
  }

  /** Writes a plan without its fence, which the format does not have. */
  public static String text(StationPlan plan) {
    StringBuilder text = new StringBuilder(HEADER).append('\n');
    StationPlan.Place home =
        plan.home().orElse(new StationPlan.Place(0.0, 0.0, OptionalDouble.empty()));
    List<Double> place =
        List.of(home.latitudeDeg(), home.longitudeDeg(), home.altitudeM().orElse(0.0));
    line(text, PlanItem.at(0, PlanItem.WAYPOINT, PlanItem.GLOBAL, place), true);
    plan.items().forEach(item -> line(text, item.withNorth360(), false));
    return text.toString();
  }

  private static void line(StringBuilder text, PlanItem item, boolean isHome) {
    text.append(item.id())
        .append('\t')
        .append(isHome ? 1 : 0)
        .append('\t')
        .append(item.frame())
        .append('\t')
        .append(item.command());
    for (int i = 1; i <= PlanItem.PARAMETERS; i++) {
      text.append('\t').append(item.parameter(i));
    }
    text.append("\t1\n");
  }
}
