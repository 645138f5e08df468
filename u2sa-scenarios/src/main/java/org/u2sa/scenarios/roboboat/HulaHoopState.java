package org.u2sa.scenarios.roboboat;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

/**
 * {@link HulaHoop}: turns the bow, where the gun is mounted, to the hoop and fires while it points
 * there. A navigation point of the subsystem DART GUN triggers the gun.
 */
final class HulaHoopState extends StationTaskState {
  /** Subsystem of the gun, and its actuator. */
  static final String GUN = "DART GUN";

  private static final double AIMED_RAD = Math.toRadians(3.0);
  private static final double STEADY_S = 0.3; // time aimed before a shot
  private static final double ORDER_S = 0.6; // longer than the gun's interlock time
  private static final double RELOAD_S = 3.0;
  private static final double UNSEEN_S = 45.0; // time at the station before giving up
  private static final double NEAREST_M = 2.0; // range of the shots
  private static final double FARTHEST_M = 6.5;

  private long shots;
  private long aimedMicros; // start time; Long.MIN_VALUE: not started
  private long firedMicros; // last order; Long.MIN_VALUE: none

  HulaHoopState(PlannerView surroundings) {
    super(surroundings);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return HulaHoop.class;
  }

  @Override
  void begin(BoatTask task) {
    shots = 0;
    aimedMicros = Long.MIN_VALUE;
    firedMicros = Long.MIN_VALUE;
  }

  @Override
  Plan work(BoatTask task, Pursuit pursuit, double sinceS) {
    HulaHoop goal = (HulaHoop) task;
    StateInformation state = pursuit.state();
    HulaHoop now = goal.copy().fired(shots, sinceS);
    boolean isFiring = firedMicros != Long.MIN_VALUE && sinceFiredS(state) < ORDER_S;
    if (!isFiring && (shots >= goal.maxShots() || sinceS >= goal.maxSeconds())) {
      String remark = String.format(Locale.ROOT, "done: %d shots in %.0f s", shots, sinceS);
      return new Plan(List.of(), Plan.Progress.COMPLETED, remark).changing(now);
    }
    Optional<Point> hoop =
        goal.objectTypes().stream()
            .findFirst()
            .flatMap(type -> nearest(type, station(goal, state), goal, state))
            .map(object -> surroundings.centre(object, state));
    if (hoop.isEmpty()) {
      return shots == 0 && sinceS > UNSEEN_S
          ? givenUp("no " + goal.objectTypes() + " was seen").changing(now)
          : lookOut(goal, state).changing(now);
    }
    Point here = surroundings.here(state);
    double bearing = Math.atan2(hoop.get().y() - here.y(), hoop.get().x() - here.x());
    double range = here.flatDistanceTo(hoop.get());
    NavigationPoint point = facing(goal, state, bearing);
    boolean isAimed =
        Math.abs(point.turn().orElseThrow()) < AIMED_RAD && range > NEAREST_M && range < FARTHEST_M;
    aimedMicros =
        !isAimed ? Long.MIN_VALUE : aimedMicros == Long.MIN_VALUE ? micros(state) : aimedMicros;
    if (isAimed && isSteady(state) && isLoaded(state)) {
      firedMicros = micros(state);
      shots++;
      isFiring = true;
    }
    return Plan.underWay(isFiring ? List.of(point, order()) : List.of(point)).changing(now);
  }

  private boolean isSteady(StateInformation state) {
    return Clock.seconds(micros(state) - aimedMicros) >= STEADY_S;
  }

  private boolean isLoaded(StateInformation state) {
    return firedMicros == Long.MIN_VALUE || sinceFiredS(state) >= RELOAD_S;
  }

  private double sinceFiredS(StateInformation state) {
    return Clock.seconds(micros(state) - firedMicros);
  }

  private static NavigationPoint order() {
    return NavigationPoint.at(Point.of(1.0, 0.0, 0.0)).subsystem(GUN);
  }
}
