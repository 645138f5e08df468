package org.u2sa.core.planning;

import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.time.Clock;

/**
 * The planner's configuration at one moment.
 *
 * @param lines how lines are followed
 * @param attempts passes at a waypoint before it is given up, at least 1
 * @param holdsAtEnd whether the vehicle holds where it has no goal to pursue
 * @param loiterRadiusM of the circle on which it holds [m]; 0 for the place itself
 * @param staleAfterS age at which a state is too old to plan from [s]
 * @param reportIntervalMicros time after which a report is repeated [µs]
 */
record PlanningSettings(
    LineSettings lines,
    int attempts,
    boolean holdsAtEnd,
    double loiterRadiusM,
    double staleAfterS,
    long reportIntervalMicros) {

  /** The same, with altitudes in proportion to the way. */
  PlanningSettings alongLines() {
    LineSettings linear =
        new LineSettings(
            lines.leastLookAheadM(), lines.lookAheadS(), lines.turns(), AltitudeProfile.LINEAR);
    return new PlanningSettings(
        linear, attempts, holdsAtEnd, loiterRadiusM, staleAfterS, reportIntervalMicros);
  }

  /** Declares and reads the variables. */
  static PlanningSettings of(Configurator configuration) {
    TurnAnticipation turns =
        new TurnAnticipation(
            configuration.getVariable(PlanningVariables.TURN_ACCELERATION),
            configuration.getVariable(PlanningVariables.TURN_LAG),
            configuration.getVariable(PlanningVariables.CORNER_LIMIT));
    LineSettings lines =
        new LineSettings(
            configuration.getVariable(PlanningVariables.LOOK_AHEAD),
            configuration.getVariable(PlanningVariables.LOOK_AHEAD_TIME),
            turns,
            AltitudeProfile.valueOf(configuration.getVariable(PlanningVariables.ALTITUDE_PROFILE)));
    return new PlanningSettings(
        lines,
        configuration.getVariable(PlanningVariables.ATTEMPTS),
        configuration.getVariable(PlanningVariables.AT_END).equals(PlanningVariables.HOLD),
        configuration.getVariable(PlanningVariables.LOITER_RADIUS),
        configuration.getVariable(PlanningVariables.STALE_AFTER),
        Clock.micros(configuration.getVariable(PlanningVariables.REPORT_INTERVAL)));
  }
}
