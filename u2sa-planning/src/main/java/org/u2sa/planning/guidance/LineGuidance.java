package org.u2sa.planning.guidance;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.LineSettings.AltitudeProfile;
import org.u2sa.service.handover.HandOver;

/**
 * Follows the straight lines between waypoints by any {@link GuidanceLaw}; decides when a leg
 * starts and ends, and when the vehicle turns to the next one.
 *
 * <p>If the leg has no given start, the vehicle heads straight for the waypoint, and the leg starts
 * where it has turned toward it. If a waypoint lies inside the turning circle, the vehicle first
 * moves away from it.
 */
public final class LineGuidance implements WaypointGuidance {
  /** Maximum difference of course and bearing of a vehicle that heads for the waypoint [rad]. */
  private static final double ALIGNED_RAD = Math.toRadians(5.0);

  /** In turning radii: a waypoint nearer than this to the circle's centre cannot be turned to … */
  private static final double INSIDE_CIRCLE = 1.2;

  /** … so the vehicle moves away until it is farther than this (hysteresis). */
  private static final double OUTSIDE_CIRCLE = 1.6;

  /**
   * In an anticipated turn, passed when the distance has grown by this fraction of the threshold …
   */
  private static final double PASSED_SHARE = 0.2;

  /** … by the distance travelled in this time, whichever is more [s]. */
  private static final double PASSED_S = 1.0;

  /** Growth of the distance beyond noise: the closest approach is past [m]. */
  private static final double GROWN_M = 1.0;

  /** Longer gaps between states are ignored by a law with a memory [s]. */
  private static final double LONGEST_STEP_S = 1.0;

  /** Minimum speed for learning: a slower vehicle may be moored, drifting or disarmed [m/s]. */
  private static final double SLOWEST_MPS = 0.2;

  private final Supplier<LineSettings> settings;
  private final GuidanceLaw law;
  private Optional<Place> start = Optional.empty();
  private boolean leaving; // moves away from a waypoint inside its turning circle
  private boolean turning; // already follows the next leg
  private double nearestM; // minimum since heading for the target or turning at it
  private double distanceM; // current distance to the target
  private double nearM; // within this, a vehicle that turns in place may leave the target
  private boolean passed;
  private OptionalLong steppedMicros = OptionalLong.empty(); // last step on this line

  public LineGuidance(Supplier<LineSettings> settings) {
    this(settings, GuidanceLaw.carrot());
  }

  public LineGuidance(Supplier<LineSettings> settings, GuidanceLaw law) {
    this.settings = settings;
    this.law = law;
  }

  @Override
  public void begin(Optional<Place> newStart) {
    start = newStart.filter(Place::isHorizontal);
    leaving = false;
    turning = false;
    nearestM = Double.POSITIVE_INFINITY;
    distanceM = Double.POSITIVE_INFINITY;
    passed = false;
    beginLine();
  }

  private void beginLine() {
    law.begin();
    steppedMicros = OptionalLong.empty();
  }

  @Override
  public void handOver(HandOver state) {
    start.ifPresent(place -> place.handOver(state, "LEG START"));
    state
        .flag("LEAVING", leaving)
        .flag("TURNING", turning)
        .flag("PASSED", passed)
        .number("NEAREST ON LEG", nearestM)
        .number("DISTANCE", distanceM);
    law.handOver(state);
  }

  @Override
  public void takeOver(HandOver state) {
    start = Place.takenOver(state, "LEG START");
    leaving = state.flag("LEAVING");
    turning = state.flag("TURNING");
    passed = state.flag("PASSED");
    nearestM = state.number("NEAREST ON LEG").orElse(Double.POSITIVE_INFINITY);
    distanceM = state.number("DISTANCE").orElse(Double.POSITIVE_INFINITY);
    law.takeOver(state);
  }

  @Override
  public boolean hasPassed() {
    return passed;
  }

  @Override
  public boolean isNearest() {
    boolean turnsHere = turnsOnTheSpot() && distanceM <= nearM;
    return turnsHere || passed || distanceM > nearestM + GROWN_M;
  }

  @Override
  public boolean isApproaching() {
    return start.isPresent();
  }

  private boolean turnsOnTheSpot() {
    return settings.get().turns().accelerationMps2() == 0.0;
  }

  @Override
  public Point bodyPoint(Vehicle vehicle, Point ned) {
    return vehicle.body(ned);
  }

  @Override
  public Point towards(Vehicle vehicle, Place target, double threshold, Optional<Place> after) {
    Point to = vehicle.nedOf(target);
    distanceM = Math.hypot(to.x(), to.y());
    nearM = settings.get().turns().nearM(threshold);
    nearestM = Math.min(nearestM, distanceM);
    if (start.isEmpty() && isHeadingFor(vehicle, to)) {
      start = Optional.of(vehicle.place());
      nearestM = distanceM; // distances while turning round do not count as an approach
    }
    Optional<Leg> leg =
        start.map(from -> legFrom(vehicle.nedOf(from), to)).filter(l -> !l.isPoint());
    Point ned;
    if (leg.isEmpty()) {
      ned = straightTo(vehicle, to);
    } else {
      Optional<Point> beyond = after.filter(Place::isHorizontal).map(vehicle::nedOf);
      Optional<Leg> next = beyond.map(point -> legFrom(to, point)).filter(l -> !l.isPoint());
      beginTurnIfDue(vehicle, leg.get(), next, threshold);
      passed = turning ? isBehind(vehicle, threshold) : leg.get().remainingM(0.0, 0.0) <= 0.0;
      ned =
          turning && next.isPresent()
              ? ahead(
                  vehicle,
                  next.get(),
                  settings.get().altitudes().along(target, after.get(), vehicle, to.z()))
              : ahead(
                  vehicle,
                  leg.get(),
                  settings.get().altitudes().along(start.get(), target, vehicle, to.z()));
    }
    return bodyPoint(vehicle, ned);
  }

  private static Leg legFrom(Point from, Point to) {
    return new Leg(from.x(), from.y(), to.x(), to.y());
  }

  private boolean isHeadingFor(Vehicle vehicle, Point to) {
    double bearing = Math.atan2(to.y(), to.x());
    return turnsOnTheSpot() || Math.abs(Leg.wrapped(bearing - vehicle.courseRad())) < ALIGNED_RAD;
  }

  /** Point without a leg: the target, or straight ahead if that is inside the turning circle. */
  private Point straightTo(Vehicle vehicle, Point to) {
    double radius = settings.get().turns().radiusM(vehicle.speedMps());
    double course = vehicle.courseRad();
    double right = to.y() * Math.cos(course) - to.x() * Math.sin(course);
    double along = to.x() * Math.cos(course) + to.y() * Math.sin(course);
    double fromCentre = Math.hypot(along, Math.abs(right) - radius);
    leaving =
        fromCentre < (leaving ? OUTSIDE_CIRCLE : INSIDE_CIRCLE) * radius
            && Math.abs(Math.atan2(right, along)) > ALIGNED_RAD;
    double bearing = leaving || distanceM == 0.0 ? course : Math.atan2(to.y(), to.x());
    double ahead = settings.get().lookAheadM(vehicle.speedMps());
    if (turnsOnTheSpot()) {
      ahead = Math.min(ahead, distanceM);
    }
    return Point.of(ahead * Math.cos(bearing), ahead * Math.sin(bearing), to.z());
  }

  private void beginTurnIfDue(Vehicle vehicle, Leg leg, Optional<Leg> next, double threshold) {
    if (turning || next.isEmpty()) {
      return;
    }
    double turn = leg.turnToRad(next.get());
    double inside = Math.signum(turn) * leg.acrossM(0.0, 0.0);
    double remaining = leg.remainingM(0.0, 0.0);
    double distance = settings.get().turns().distanceM(vehicle.speedMps(), turn, inside, threshold);
    if (remaining <= distance && Math.abs(inside) <= threshold) {
      turning = true;
      beginLine();
      nearestM = distanceM; // a wide turn into the leg may have come closer than this
    }
  }

  private boolean isBehind(Vehicle vehicle, double threshold) {
    return distanceM > nearestM + Math.max(PASSED_SHARE * threshold, PASSED_S * vehicle.speedMps());
  }

  /** Point on a leg ahead of the vehicle; for a vehicle that turns in place, not past the end. */
  private Point ahead(Vehicle vehicle, Leg leg, AltitudeProfile.Slope altitudes) {
    double lookAhead = settings.get().lookAheadM(vehicle.speedMps());
    double along = leg.alongM(0.0, 0.0) + lookAhead;
    double down = altitudes.downM(Math.min(along, limit(leg)) / leg.lengthM());
    if (along > limit(leg)) {
      return Point.of(leg.northAtM(leg.lengthM()), leg.eastAtM(leg.lengthM()), down);
    }
    advance(vehicle, leg, lookAhead);
    Point ahead = law.pointAhead(leg, lookAhead);
    return Point.of(ahead.x(), ahead.y(), down);
  }

  private void advance(Vehicle vehicle, Leg leg, double lookAheadM) {
    long now = vehicle.timestampMicros();
    double stepS = Clock.seconds(now - steppedMicros.orElse(now));
    double alongMps =
        vehicle.northMps() * Math.cos(leg.bearingRad())
            + vehicle.eastMps() * Math.sin(leg.bearingRad());
    if (stepS > 0.0 && stepS <= LONGEST_STEP_S && alongMps >= SLOWEST_MPS) {
      law.advance(leg, lookAheadM, stepS);
    }
    steppedMicros = OptionalLong.of(now);
  }

  /** Maximum along-track distance of the target point [m]. */
  private double limit(Leg leg) {
    return turnsOnTheSpot() ? leg.lengthM() : Double.POSITIVE_INFINITY;
  }
}
