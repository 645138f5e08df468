package org.u2sa.planning.guidance;

import java.util.Locale;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;

/**
 * Monitors whether an aeroplane advances towards its navigation points, which a wind faster than
 * itself prevents. Time without headway begins when it falls behind {@link #MIN_MPS}, and ends when
 * it has caught up; a turn costs {@link #BEHIND_M} at most. Confined to the planner's thread.
 */
public final class HeadwayWatch {
  private static final double MIN_MPS = 1.0; // over ground, towards the navigation point
  private static final double BEHIND_M = 20.0;
  private static final double LONGEST_STEP_S = 1.0;
  private static final double WARNED_SHARE = 0.5; // of the time after which a goal is given up

  private final Consumer<String> trouble;
  private final BiConsumer<String, String> remark;
  private double behindM;
  private double withoutS; // time without headway, for this goal
  private double advancedM; // in that time
  private boolean isWarned;
  private long beforeMicros = Long.MIN_VALUE; // previous state

  /**
   * @param trouble what the operator must know
   * @param remark part of the health and text; an empty text ends it
   */
  public HeadwayWatch(Consumer<String> trouble, BiConsumer<String, String> remark) {
    this.trouble = trouble;
    this.remark = remark;
  }

  /** Begins a goal, which gets the full time; a warning that was given is not repeated. */
  public void begin() {
    withoutS = 0.0;
    advancedM = 0.0;
  }

  /** The vehicle is not being led. */
  public void leave() {
    beforeMicros = Long.MIN_VALUE;
    hasHeadway();
  }

  private void hasHeadway() {
    begin();
    behindM = 0.0;
    if (isWarned) {
      isWarned = false;
      remark.accept("headway", "");
    }
  }

  /**
   * Processes a state.
   *
   * @param body navigation point in the vehicle's axes
   * @param giveUpAfterS time without headway after which a goal is given up; 0: never
   * @return why to give the goal up; empty if there is no reason
   */
  public Optional<String> step(
      Vehicle vehicle, StateInformation state, Point body, double giveUpAfterS) {
    Point to = vehicle.ned(body);
    double distanceM = Math.hypot(to.x(), to.y());
    long now = vehicle.timestampMicros();
    double stepS =
        beforeMicros == Long.MIN_VALUE
            ? 0.0
            : Math.max(0.0, Math.min(LONGEST_STEP_S, Clock.seconds(now - beforeMicros)));
    beforeMicros = now;
    if (giveUpAfterS <= 0.0 || distanceM == 0.0) {
      return Optional.empty();
    }
    double towardsMps = (vehicle.northMps() * to.x() + vehicle.eastMps() * to.y()) / distanceM;
    behindM = Math.min(BEHIND_M, behindM + (MIN_MPS - towardsMps) * stepS);
    if (behindM <= 0.0) {
      hasHeadway();
      return Optional.empty();
    }
    withoutS += stepS;
    advancedM += towardsMps * stepS;
    if (withoutS >= WARNED_SHARE * giveUpAfterS && !isWarned) {
      isWarned = true;
      trouble.accept(words(vehicle, state));
      remark.accept("headway", words(vehicle, state));
    }
    return withoutS >= giveUpAfterS ? Optional.of(words(vehicle, state)) : Optional.empty();
  }

  private String words(Vehicle vehicle, StateInformation state) {
    String wind =
        AirMass.wind(state, vehicle)
            .map(each -> String.format(Locale.ROOT, ", in %.0f m/s of wind", each.distance()))
            .orElse("");
    double meanMps = withoutS > 0.0 ? advancedM / withoutS : 0.0;
    return String.format(
        Locale.ROOT, "no headway for %.0f s: %.1f m/s on average%s", withoutS, meanMps, wind);
  }
}
