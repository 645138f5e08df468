package org.u2sa.planning.flight;

import java.util.List;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.guidance.LineSettings;

/** The planner states of aircraft. */
public final class FlightStates {
  private FlightStates() {}

  /**
   * @param planner its variables
   * @param lines settings of line following; turns of no acceleration: it can stop in the air
   * @param loiterRadiusM radius of circles [m]; 0: it stays in place
   */
  public static List<PlannerState> of(
      Configurator planner, Supplier<LineSettings> lines, Supplier<Double> loiterRadiusM) {
    Settings<FlightVariables> settings = planner.settings(FlightVariables.class);
    return List.of(
        new TakeOffState(lines, settings),
        new LandingState(lines, loiterRadiusM, settings),
        new PayloadDropState(lines, settings));
  }
}
