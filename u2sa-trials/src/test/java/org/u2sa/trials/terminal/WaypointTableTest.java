package org.u2sa.trials.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.report.score.FlightFigures;
import org.u2sa.report.score.ObstacleResult;
import org.u2sa.report.score.RunDetails;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.WaypointResult;

class WaypointTableTest {

  private static WaypointResult result(
      String name,
      OptionalDouble miss,
      OptionalDouble error,
      OptionalDouble time,
      boolean captured) {
    return new WaypointResult(
        new RunPlan.Waypoint(
            name, 0.0, 0.0, OptionalDouble.of(300.0), 100.0, OptionalDouble.empty()),
        miss,
        error,
        time,
        captured);
  }

  private static RunScore score() {
    return new RunScore(
        List.of(
            result(
                "Ridge",
                OptionalDouble.of(12.34),
                OptionalDouble.of(-2.5),
                OptionalDouble.of(83.6),
                true),
            result(
                "Lighthouse",
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                false)),
        OptionalDouble.of(8.25),
        OptionalDouble.of(31.0),
        Optional.of(
            new FlightFigures(
                OptionalDouble.empty(),
                OptionalDouble.empty(),
                OptionalDouble.of(Math.toRadians(27.5)),
                OptionalDouble.of(33.3),
                true)),
        List.of(
            new ObstacleResult("tower", false, 81.26, 120.0, false),
            new ObstacleResult("N101", true, 3.5, 61.0, true)),
        new RunOutcome(0, false, List.of("geofence left at 12.0 s")),
        600.0);
  }

  private static String printed(boolean colours, int columns) {
    StringWriter text = new StringWriter();
    RunDetails facts = new RunDetails("cessna", 1, "embedded", 1.0, OptionalInt.empty());
    Terminal terminal = new Terminal(new PrintWriter(text), colours, colours, columns);
    WaypointTable.print(terminal, facts, score());
    return text.toString();
  }

  @Test
  void print_plain_isATable() {
    assertThat(printed(false, 80))
        .isEqualToNormalizingNewlines(
            """
                 waypoint    miss [m]    altitude      time  captured
              1  Ridge           12.3      -2.5 m      1:24  yes
              2  Lighthouse         -           -         -  NO

                 obstacle    near [m]      time
                 tower           81.3      2:00
                 N101             3.5      1:01  TOUCHED

            cross-track RMS 8.3 m (whole legs 31.0 m)
            altitude on level legs: RMS -, maximum -
            maximum bank 27.5 deg, minimum airspeed 33.3 m/s
            simulated 10:00
            1 of 2 waypoints captured
            violation: geofence left at 12.0 s
            """);
  }

  @Test
  void print_colours_marksGoodAndBad() {
    assertThat(printed(true, 80))
        .contains(
            "\u001b[32myes\u001b[0m",
            "\u001b[31mNO\u001b[0m",
            "\u001b[31m1 of 2 waypoints captured\u001b[0m");
  }

  @Test
  void print_narrow_neverWraps() {
    assertThat(printed(false, 40).lines())
        .allSatisfy(line -> assertThat(line.length()).isLessThan(40));
  }
}
