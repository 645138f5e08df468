package org.u2sa.messages.goal;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.messages.Metric;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * An area to be imaged completely from above at a ground resolution (thesis 4.4.1.3). The World
 * Modeler records what was seen; the Path Planner flies over the remaining parts.
 */
public class SearchArea extends GoalInformation {
  /** Finest resolution that may be requested [m]. */
  public static final double MIN_RESOLUTION_M = 0.005;

  private static final int MAX_CORNERS = 200;
  private static final double MAX_RESOLUTION_M = 1.27; // of the coverage ledger

  private static final double MAX_SIDE_M = 75_000.0;

  private static final Schema<SearchArea> SCHEMA =
      Schema.of(SearchArea.class, SearchArea::new, GoalInformation.TYPE).since(3);
  private static final ValueField<SearchArea, ReferenceFrame> FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.GLOBAL);
  private static final ValueField<SearchArea, List<Point>> CORNERS = SCHEMA.points("corners", "m");
  private static final NumberField<SearchArea> RESOLUTION =
      SCHEMA.requiredNumber("resolution", "m", MIN_RESOLUTION_M, MAX_RESOLUTION_M);
  private static final NumberField<SearchArea> GROUND = SCHEMA.number("ground", "m", 0.0);
  private static final NumberField<SearchArea> LOWEST = SCHEMA.optionalNumber("lowest", "m");
  private static final NumberField<SearchArea> HIGHEST = SCHEMA.optionalNumber("highest", "m");
  private static final NumberField<SearchArea> SPEED = SCHEMA.optionalNumber("speed", "m/s", 0.0);
  private static final NumberField<SearchArea> SHARE =
      SCHEMA.optionalNumber("share", "1", 0.0, 1.0);
  private static final NumberField<SearchArea> SEEN = SCHEMA.optionalNumber("seen", "1", 0.0, 1.0);

  public static final MessageType<SearchArea> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends SearchArea> type() {
    return TYPE;
  }

  /** Frame of the corners. */
  public ReferenceFrame referenceFrame() {
    return get(FRAME);
  }

  public SearchArea referenceFrame(ReferenceFrame frame) {
    return put(FRAME, frame);
  }

  /** Corners of the outline in order, at least three, either way round; it may be concave. */
  public List<Point> corners() {
    return require(CORNERS);
  }

  public SearchArea corners(List<Point> points) {
    return put(CORNERS, points);
  }

  /** Required ground resolution: maximum length on the ground covered by a pixel [m]. */
  public double resolution() {
    return require(RESOLUTION);
  }

  public SearchArea resolution(double metres) {
    return put(RESOLUTION, metres);
  }

  /** Altitude of the ground above mean sea level [m]; defaults to 0. */
  public double ground() {
    return get(GROUND).orElse(0.0);
  }

  public SearchArea ground(double metres) {
    return put(GROUND, metres);
  }

  /** Minimum altitude above mean sea level [m]. */
  public OptionalDouble lowest() {
    return get(LOWEST);
  }

  public SearchArea lowest(double metres) {
    return put(LOWEST, metres);
  }

  /** Maximum altitude above mean sea level [m]. */
  public OptionalDouble highest() {
    return get(HIGHEST);
  }

  public SearchArea highest(double metres) {
    return put(HIGHEST, metres);
  }

  /** Airspeed [m/s]; empty: the vehicle chooses. */
  public OptionalDouble speed() {
    return get(SPEED);
  }

  public SearchArea speed(double metresPerSecond) {
    return put(SPEED, metresPerSecond);
  }

  /** Sufficient fraction of the area, 0…1; empty: all of it. */
  public OptionalDouble share() {
    return get(SHARE);
  }

  public SearchArea share(double value) {
    return put(SHARE, value);
  }

  /** Share of the area seen at the resolution, 0…1, reported back. */
  public OptionalDouble seen() {
    return get(SEEN);
  }

  public SearchArea seen(double value) {
    return put(SEEN, value);
  }

  /**
   * Reason why the area cannot be searched, with field, value and expectation; empty if nothing.
   */
  public Optional<String> fault() {
    List<Point> outline = corners();
    if (outline.size() < 3 || outline.size() > MAX_CORNERS) {
      return Optional.of("corners: " + outline.size() + " of them; expected 3 to " + MAX_CORNERS);
    }
    boolean isOnEarth = referenceFrame().equals(ReferenceFrame.GLOBAL);
    for (Point corner : outline) {
      if (isOnEarth && (Math.abs(corner.y()) > 90.0 || Math.abs(corner.x()) > 360.0)) {
        return Optional.of(
            "corners: " + corner.x() + " " + corner.y() + "; expected longitude and latitude");
      }
    }
    Optional<String> crossing = Outline.crossing(isOnEarth ? unwrapped(outline) : outline);
    if (crossing.isPresent()) {
      return crossing;
    }
    Metric metric = Metric.around(referenceFrame(), outline.get(0));
    for (Point corner : outline) {
      Point away = metric.metres(corner);
      double awayM = Math.hypot(away.x(), away.y());
      if (awayM > MAX_SIDE_M) {
        return Optional.of(
            String.format(
                Locale.ROOT,
                "corners: %.0f km from the first one; expected at most %.0f km",
                awayM / 1_000.0,
                MAX_SIDE_M / 1_000.0));
      }
    }
    if (lowest().isPresent() && lowest().getAsDouble() > highest().orElse(Double.MAX_VALUE)) {
      return Optional.of(
          "lowest: " + lowest().getAsDouble() + " m is above highest; expected a lower altitude");
    }
    if (highest().orElse(Double.MAX_VALUE) <= ground()) {
      return Optional.of(
          String.format(
              Locale.ROOT,
              "highest: %.1f m; expected an altitude above the ground, %.1f m",
              highest().getAsDouble(),
              ground()));
    }
    return Optional.empty();
  }

  /** Corners with longitudes within 180° of the first one, also across the date line. */
  private static List<Point> unwrapped(List<Point> corners) {
    double first = corners.get(0).x();
    return corners.stream()
        .map(at -> Point.of(first + Math.IEEEremainder(at.x() - first, 360.0), at.y(), at.z()))
        .collect(Collectors.toList());
  }

  @Override
  protected void requireConsistent() {
    super.requireConsistent();
    fault()
        .ifPresent(
            fault -> {
              throw new IllegalStateException("SearchArea: " + fault);
            });
  }

  /** Checks of outlines. */
  private static final class Outline {
    private Outline() {}

    /** Error of an outline: its edges cross, or it encloses nothing. */
    static Optional<String> crossing(List<Point> corners) {
      int count = corners.size();
      Point origin = corners.get(0);
      double twiceArea = 0.0;
      for (int i = 0; i < count; i++) {
        Point a = corners.get(i);
        Point b = corners.get((i + 1) % count);
        twiceArea += side(origin, a, b);
        for (int k = i + 2; k < count && k - i < count - 1; k++) {
          Point c = corners.get(k);
          Point d = corners.get((k + 1) % count);
          boolean crosses =
              side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
          if (crosses) {
            return Optional.of(
                String.format(
                    "corners: the edge after corner %d crosses the one after corner %d; "
                        + "expected an outline",
                    i + 1, k + 1));
          }
        }
      }
      return twiceArea == 0.0
          ? Optional.of("corners: enclose nothing; expected an outline")
          : Optional.empty();
    }

    private static double side(Point a, Point b, Point c) {
      return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    }
  }

  @Override
  public SearchArea uid(String uid) {
    return (SearchArea) super.uid(uid);
  }

  @Override
  public SearchArea copy() {
    return (SearchArea) super.copy();
  }
}
