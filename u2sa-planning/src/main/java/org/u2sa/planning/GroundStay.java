package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.handover.HandOver;

/**
 * Whether an aircraft still or again stands on the ground, where holding a position must not lift
 * it off; and the minimum height above that ground at which an aeroplane circles or returns. An
 * multirotor has left the ground once it has been led to a goal for a second while armed, an
 * aeroplane once it is fast or high; until it has landed or is disarmed.
 */
final class GroundStay {
  private static final double AT_REST_MPS = 1.0;
  private static final double MOVES_MPS = 5.0;
  private static final double FLIES_M = 10.0; // in a head wind
  private static final double RISE_M = 2.0;
  private static final double DOWN_M = 1.0;
  private static final long LED_MICROS = Clock.MICROS_PER_SECOND;
  private static final long NEVER = Long.MIN_VALUE;

  private final Supplier<FlightVariables> settings;
  private final BooleanSupplier isAeroplane;
  private boolean armed = true; // without an arming service
  private boolean left;
  private boolean landed;
  private boolean wasLed; // since it was armed
  private boolean takesOff; // its missions contain take-offs
  private boolean returns;
  private List<Boolean> told = List.of(false, false, false, false, false);
  private boolean descends; // is being led to a landing
  private boolean touchesDown; // a multirotor, at its end
  private long firstLed = NEVER;
  private Optional<Place> stoodAt = Optional.empty(); // on the ground
  private OptionalDouble risesToM = OptionalDouble.empty(); // from the ground
  private String atGround = ""; // UID of the take-off or landing under way
  private boolean climbs; // straight ahead, before it may turn
  private OptionalDouble climbHeadingRad = OptionalDouble.empty();

  GroundStay(Supplier<FlightVariables> settings, BooleanSupplier isAeroplane) {
    this.settings = settings;
    this.isAeroplane = isAeroplane;
  }

  /** Whether something has changed that must survive a restart; once for each change. */
  boolean isNews() {
    List<Boolean> now = List.of(left, landed, takesOff, wasLed, climbs);
    boolean isNews = !now.equals(told);
    told = now;
    return isNews;
  }

  void handOver(HandOver state) {
    state.flag("LEFT GROUND", left).flag("LANDED", landed).flag("TAKES OFF", takesOff);
    state.flag("WAS LED", wasLed).flag("CLIMBS STRAIGHT", climbs).text("AT GROUND", atGround);
    state.flag("DESCENDS", descends).flag("TOUCHES DOWN", touchesDown);
    climbHeadingRad.ifPresent(heading -> state.number("CLIMB HEADING", heading));
    risesToM.ifPresent(upM -> state.number("RISES TO", upM));
    if (firstLed != NEVER) {
      state.number("FIRST LED", Clock.seconds(firstLed));
    }
    stoodAt.ifPresent(place -> place.handOver(state, "STOOD AT"));
  }

  /**
   * Continues for a predecessor.
   *
   * @param isSwap whether what was saved is that of now
   */
  void takeOver(HandOver state, boolean isSwap) {
    left = state.flag("LEFT GROUND");
    landed = state.flag("LANDED");
    takesOff = state.flag("TAKES OFF");
    wasLed = state.flag("WAS LED");
    stoodAt = Place.takenOver(state, "STOOD AT");
    climbs = state.flag("CLIMBS STRAIGHT");
    if (isSwap) {
      atGround = state.text("AT GROUND").orElse("");
      descends = state.flag("DESCENDS");
      touchesDown = state.flag("TOUCHES DOWN");
      climbHeadingRad = state.number("CLIMB HEADING");
      risesToM = state.number("RISES TO");
      OptionalDouble led = state.number("FIRST LED");
      firstLed = led.isPresent() ? Clock.micros(led.getAsDouble()) : NEVER;
    }
  }

  void heed(ArmingState state) {
    armed = state.armed();
    left &= armed;
    wasLed &= armed;
  }

  boolean isArmed() {
    return armed;
  }

  void heedGoals(GoalList goals) {
    takesOff |= goals.goals().stream().anyMatch(TakeOff.class::isInstance);
    returns = goals.returning();
  }

  /** Flown by hand, it may be anywhere afterwards. */
  void flownByHand() {
    touchesDown = false;
    left = true;
    landed = false;
  }

  void see(Vehicle vehicle) {
    OptionalDouble upM = vehicle.place().upM();
    left |= vehicle.speedMps() > MOVES_MPS; // too fast to stop, or off a catapult
    left |= upM.isPresent() && upM.getAsDouble() > groundUpM().orElse(Double.MAX_VALUE) + FLIES_M;
    if ((!left || landed) && vehicle.speedMps() < AT_REST_MPS) {
      stoodAt = Optional.of(vehicle.place());
    }
  }

  /**
   * Sees that the vehicle is led to a goal.
   *
   * @param touches whether it is about to touch down, or has
   */
  void lead(GoalInformation goal, Plan plan, boolean touches, long micros) {
    descends = goal instanceof Landing;
    touchesDown = touches && !isAeroplane.getAsBoolean();
    boolean isAbandonedAtRest =
        plan.progress() == Plan.Progress.ABANDONED && plan.points().isEmpty();
    landed = descends && (plan.progress() == Plan.Progress.COMPLETED || isAbandonedAtRest);
    left &= !landed;
    if (!armed || landed || plan.points().isEmpty()) {
      firstLed = NEVER;
    } else if (firstLed == NEVER) {
      firstLed = micros;
    }
    wasLed |= !plan.points().isEmpty();
    boolean isLed = firstLed != NEVER && micros - firstLed >= LED_MICROS;
    left |= isLed && !isAeroplane.getAsBoolean(); // which may stand while its engine starts
    boolean isAtGround = descends || goal instanceof TakeOff;
    atGround = isAtGround && plan.progress() != Plan.Progress.COMPLETED ? goal.uid() : "";
  }

  /**
   * Way straight up of a multirotor from the ground or a descent to it, relative to itself: there
   * it must not lean, as while its estimated position still moves. Empty for others, and once it
   * has risen.
   *
   * @throws IllegalArgumentException if the goal cannot be navigated to: it stays on the ground
   */
  Optional<NavigationPoint> rise(GoalInformation goal, Vehicle vehicle) {
    OptionalDouble upM = vehicle.place().upM();
    if (upM.isEmpty() || isAeroplane.getAsBoolean() || goal instanceof Landing) {
      return Optional.empty();
    }
    boolean isFirst = !left && firstLed == NEVER && goal instanceof TakeOff;
    if (landed || isFirst || descends) {
      if (goal instanceof Waypoint place) {
        vehicle.nedOf(Place.of(place));
      }
      risesToM = OptionalDouble.of(upM.getAsDouble() + RISE_M);
    }
    if (risesToM.isPresent() && upM.getAsDouble() >= risesToM.getAsDouble()) {
      risesToM = OptionalDouble.empty();
    }
    return risesToM.isPresent()
        ? Optional.of(NavigationPoint.at(vehicle.body(Point.of(0.0, 0.0, -RISE_M))))
        : Optional.empty();
  }

  /** Sees that the vehicle holds; a multirotor that is touching down completes that first. */
  void hold() {
    landed |= touchesDown;
    left &= !touchesDown;
    touchesDown = false;
    climbs |= !atGround.isEmpty();
    atGround = "";
    firstLed = NEVER;
    risesToM = OptionalDouble.empty();
  }

  /**
   * Way straight ahead and up of an aeroplane that holds, or whose take-off or landing gives way to
   * another goal, while it is lower than half the minimum height, or still sinks below that height:
   * a turn there would bring a wing near the ground. Empty for others, and once it has climbed.
   */
  Optional<NavigationPoint> climb(Optional<GoalInformation> goal, Vehicle vehicle, double aheadM) {
    String uid = goal.map(GoalInformation::uid).orElse("");
    boolean takesOff = goal.filter(TakeOff.class::isInstance).isPresent();
    OptionalDouble leastM = leastUpM();
    double lowM = leastM.orElse(0.0) - vehicle.place().upM().orElse(Double.POSITIVE_INFINITY);
    boolean isLow = lowM > settings.get().minHoldHeight() / 2.0;
    climbs |= goal.isEmpty() ? isLow : !(atGround.isEmpty() || atGround.equals(uid));
    climbs &= isLow || lowM > 0.0 && vehicle.downMps() > 0.0;
    climbs &= !takesOff && left && leastM.isPresent();
    if (!climbs) {
      climbHeadingRad = OptionalDouble.empty();
      return Optional.empty();
    }
    double headingRad = climbHeadingRad.orElse(vehicle.headingRad());
    climbHeadingRad = OptionalDouble.of(headingRad);
    double northM = aheadM * Math.cos(headingRad);
    double eastM = aheadM * Math.sin(headingRad);
    Point ahead = Point.of(northM, eastM, -lowM);
    return Optional.of(NavigationPoint.at(vehicle.body(ahead)));
  }

  /** Where it last stood on the ground; empty without take-offs: it may have started in the air. */
  Optional<Place> stoodAt() {
    return takesOff ? stoodAt : Optional.empty();
  }

  private OptionalDouble groundUpM() {
    return stoodAt.map(Place::upM).orElse(OptionalDouble.empty());
  }

  /** Whether it stands where a landing has ended. */
  boolean hasLanded() {
    return landed;
  }

  /** Whether it has left the ground and has not landed. */
  boolean flies() {
    return left && !landed;
  }

  /** Whether holding means staying on the ground. */
  boolean stays() {
    return landed || (!left && (isAeroplane.getAsBoolean() || takesOff));
  }

  /** Whether its goals lead home or to a landing, although it is on the ground. */
  boolean isBack() {
    return returns && stays();
  }

  /**
   * Points that keep it on the ground if it was led before, because the last one still counts for a
   * while: an aeroplane at a speed of 0, a multirotor straight down, because without a point its
   * control would hover, and drag it along with every error of its velocity.
   */
  List<NavigationPoint> points(Vehicle vehicle) {
    if (!landed && !wasLed) {
      return List.of();
    }
    return isAeroplane.getAsBoolean()
        ? List.of(NavigationPoint.at(Point.of(1.0, 0.0, 0.0)).speed(0.0))
        : List.of(NavigationPoint.at(vehicle.body(Point.of(0.0, 0.0, DOWN_M))));
  }

  /** A place at the minimum height at least; unchanged without altitude. */
  Place raised(Place place) {
    OptionalDouble leastM = leastUpM();
    boolean isLow =
        leastM.isPresent() && place.upM().orElse(leastM.getAsDouble()) < leastM.getAsDouble();
    return isLow ? place.at(leastM.getAsDouble()) : place;
  }

  /** A waypoint without altitude, at the minimum height while the vehicle is lower. */
  GoalInformation raised(GoalInformation goal, Vehicle vehicle) {
    boolean isOpen = goal instanceof Waypoint open && open.z().isEmpty();
    Place here = vehicle.place();
    Place raised = isOpen ? raised(here) : here;
    if (raised.equals(here)) {
      return goal;
    }
    Waypoint copy = ((Waypoint) goal).copy();
    double upM = raised.upM().orElseThrow();
    return copy.z(copy.referenceFrame().equals(ReferenceFrame.LOCAL_NED) ? -upM : upM);
  }

  private OptionalDouble leastUpM() {
    double heightM = settings.get().minHoldHeight();
    OptionalDouble groundUpM = groundUpM();
    return isAeroplane.getAsBoolean() && groundUpM.isPresent() && heightM > 0.0
        ? OptionalDouble.of(groundUpM.getAsDouble() + heightM)
        : OptionalDouble.empty();
  }
}
