package org.u2sa.scenarios.fields;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Rover and small aeroplane in fields that nobody has tuned them for. */
class RandomFieldsTest {
  private static final double NEARLY_ALL = 0.98;

  @Test
  void rover_someFields_noContactAndSolved() {
    FieldSeries series = rover(RoverEyes.Kind.KNOWN);
    series.run(1, 4);
    series.check(NEARLY_ALL);
  }

  @Test
  void aircraft_someFields_noContactAndSolved() {
    FieldSeries series = aircraft("AIR");
    series.run(1, 6);
    series.check(NEARLY_ALL);
  }

  /** Field 1144: it was off its route, on whose other side there was traffic. */
  @Test
  void aircraft_trafficBetweenItAndItsRoute_isNotTouched() {
    FieldSeries series = aircraft("AIR");
    series.run(1144, 1145);
    series.check(NEARLY_ALL);
  }

  /** Field 1105, by one who forgets what is out of sight: it would circle before the same wall. */
  @Test
  @Tag("long")
  void aircraft_forgetsTheDeadEnd_givesUpWithThatReason() {
    try (AircraftRun run = new AircraftRun(new RandomField(AircraftRun.KIND, 1105), "AIR", false)) {
      FieldResult result = run.run();
      assertThat(result.reached()).isFalse();
      assertThat(result.reason()).contains("no closer to the goal for");
      assertThat(result.contacts()).isEmpty();
    }
  }

  @Test
  @Tag("long")
  void rover_twoHundredFields_noContactAndNearlyAllSolved() {
    FieldSeries series = rover(RoverEyes.Kind.KNOWN);
    series.run(1000, 1200);
    series.check(NEARLY_ALL);
  }

  @Test
  @Tag("long")
  void rover_seesByTheWorldModeler_noContactAndNearlyAllSolved() {
    FieldSeries series = rover(RoverEyes.Kind.DETECTOR);
    series.run(1000, 1040);
    series.check(NEARLY_ALL);
  }

  @Test
  @Tag("long")
  void aircraft_twoHundredFields_noContactAndNearlyAllSolved() {
    FieldSeries series = aircraft("AIR");
    series.run(1000, 1200);
    series.check(NEARLY_ALL);
  }

  @Test
  @Tag("long")
  void aircraft_twoHundredFieldsByTheGrid_noContactAndNearlyAllSolved() {
    FieldSeries series = aircraft("HYBRID");
    series.run(1000, 1200);
    series.check(NEARLY_ALL);
  }

  private static FieldSeries rover(RoverEyes.Kind sees) {
    return new FieldSeries(
        RoverRun.KIND,
        field -> {
          try (RoverRun run = new RoverRun(field, sees)) {
            return run.run();
          }
        },
        field -> field.isSolvable(RoverRun.NEEDED_M, 0.1));
  }

  private static FieldSeries aircraft(String planner) {
    return new FieldSeries(
        AircraftRun.KIND,
        field -> {
          try (AircraftRun run = new AircraftRun(field, planner)) {
            return run.run();
          }
        },
        field ->
            new TurningFlood(field, AircraftRun.NEEDED_M, 10.0).reaches(AircraftRun.TURN_M, 28.0));
  }
}
