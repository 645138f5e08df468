package org.u2sa.scenarios.fields;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The rover meets one who walks straight on, whatever is in his way. It may be touched while it
 * stands or backs off, but never drives into him, and does not give its goal up for him.
 */
class WalkerTest {
  private static final double WALKER_M = 0.3;
  private static final double ROVER_MPS = 0.95;

  private final RandomField field =
      new RandomField(
          new RandomField.Kind(28.0, 0.25, 1.6, 0.0, 1.2, 0, WALKER_M, 0.5, 0, false), 1);
  private final double wayM =
      Math.hypot(field.goalEast - field.startEast, field.goalNorth - field.startNorth);

  /** A place by its way from start to goal, and to the right of that: east, north [m]. */
  private double[] at(double along, double right) {
    double east = (field.goalEast - field.startEast) / wayM;
    double north = (field.goalNorth - field.startNorth) / wayM;
    return new double[] {
      field.startEast + along * east + right * north,
      field.startNorth + along * north - right * east
    };
  }

  private void walks(double[] from, double[] to, double mps) {
    double[] ends = {from[0], from[1], to[0], to[1]};
    field.traffic.add(new RandomField.Traffic(ends, WALKER_M, mps, 0.0));
  }

  private FieldResult drive(RoverEyes.Kind sees) {
    try (RoverRun run = new RoverRun(field, sees)) {
      return run.run();
    }
  }

  private void requireReached(RoverEyes.Kind sees) {
    FieldResult result = drive(sees);
    assertThat(result.contacts()).isEmpty();
    assertThat(result.reason()).isEmpty();
    assertThat(result.reached()).isTrue();
  }

  @ParameterizedTest
  @CsvSource({"0.3, 0.0", "1.5, 0.25"})
  void headOn_asWorldModelerSeesHim_isNotDrivenInto(double mps, double aside) {
    walks(at(wayM + 3.0, aside), at(-40.0, aside), mps);
    requireReached(RoverEyes.Kind.DETECTOR);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({"0.3, 0.25", "1.5, 0.0", "1.5, -0.25"})
  void headOn_asWorldModelerSeesHimFartherAside_isNotDrivenInto(double mps, double aside) {
    headOn_asWorldModelerSeesHim_isNotDrivenInto(mps, aside);
  }

  @ParameterizedTest
  @CsvSource({"1.0, 0.75", "1.5, -0.75"})
  void crossing_asWorldModelerSeesHim_isNotDrivenInto(double mps, double laterS) {
    double meetS = 2.0 + 0.5 * wayM / ROVER_MPS + laterS;
    walks(at(0.5 * wayM, mps * meetS), at(0.5 * wayM, -60.0), mps);
    requireReached(RoverEyes.Kind.DETECTOR);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({"0.3, 0.0", "1.5, 0.0"})
  void crossing_asWorldModelerSeesHimAtOtherTimes_isNotDrivenInto(double mps, double laterS) {
    crossing_asWorldModelerSeesHim_isNotDrivenInto(mps, laterS);
  }

  @ParameterizedTest
  @CsvSource({"0.0", "0.25", "0.5"})
  void headOn_fastAndItsVelocityKnown_isNotTouched(double aside) {
    walks(at(wayM + 3.0, aside), at(-40.0, aside), 1.5);
    FieldResult result = drive(RoverEyes.Kind.KNOWN);
    assertThat(result.contacts()).isEmpty();
    assertThat(result.touchedBy()).isEmpty();
    assertThat(result.reached()).isTrue();
  }

  @ParameterizedTest
  @CsvSource({"0.3, 0.0", "1.0, 0.25", "1.5, 0.0"})
  void headOn_asALaserAloneSeesHim_isNotDrivenInto(double mps, double aside) {
    walks(at(wayM + 3.0, aside), at(-40.0, aside), mps);
    requireReached(RoverEyes.Kind.LASER);
  }

  /** Half of these were driven into while only the grid showed them. */
  @ParameterizedTest
  @CsvSource({"0.6, 0.0", "1.5, -0.75"})
  void crossing_asALaserAloneSeesHim_isNotDrivenInto(double mps, double laterS) {
    double meetS = 2.0 + 0.5 * wayM / ROVER_MPS + laterS;
    walks(at(0.5 * wayM, mps * meetS), at(0.5 * wayM, -60.0), mps);
    requireReached(RoverEyes.Kind.LASER);
  }

  @Tag("long")
  @ParameterizedTest
  @CsvSource({"0.6, -0.75", "1.0, 0.0", "1.0, 0.75", "1.5, 0.75"})
  void crossing_asALaserAloneSeesHimAtOtherTimes_isNotDrivenInto(double mps, double laterS) {
    crossing_asALaserAloneSeesHim_isNotDrivenInto(mps, laterS);
  }
}
