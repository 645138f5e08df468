package org.u2sa.device.detection;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.PathMarker;
import org.u2sa.testkit.ServiceKit;

/** A detector that sees a buoy 10 m to the left and a pole straight ahead. */
class ObjectDetectorSensorTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private void start() {
    kit.start(context -> new ObjectDetectorSensor(context, new TwoThings()));
  }

  /** Types published from now on. */
  private List<String> typesSeen() {
    int before = kit.published(Channels.SENSED_OBJECTS).size();
    kit.advance(0.5);
    return kit.published(Channels.SENSED_OBJECTS).stream()
        .skip(before)
        .map(ObjectDescription::objectType)
        .distinct()
        .sorted()
        .toList();
  }

  private void seek(String type) {
    kit.publish(
        Channels.GOALS,
        new GoalList().goals(List.of(new ObjectGoal().objectType(type).within(1.0).uid("goal"))));
  }

  @Test
  void step_buoyToTheLeft_isABuoyInBodyWithItsErrorsAlongTheLineOfSight() {
    kit.with("MOUNTED X", 0.5).with("MOUNTED Z", -1.0);
    start();
    kit.advance(0.2);

    Buoy buoy =
        kit.published(Channels.SENSED_OBJECTS).stream()
            .filter(Buoy.class::isInstance)
            .map(Buoy.class::cast)
            .findFirst()
            .orElseThrow();
    assertThat(buoy.colour()).hasValue(Colour.RED);
    assertThat(buoy.radius()).isEqualTo(0.2);
    assertThat(buoy.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(buoy.x()).isCloseTo(0.5, within(1e-9));
    assertThat(buoy.y()).isCloseTo(10.0, within(1e-9));
    assertThat(buoy.z()).isCloseTo(-1.0, within(1e-9));
    assertThat(buoy.motion().sigma().orElseThrow().y()).as("range").isCloseTo(0.5, within(1e-9));
    assertThat(buoy.motion().sigma().orElseThrow().x()).as("bearing").isCloseTo(0.1, within(1e-9));
  }

  @Test
  void step_markerBelowACameraThatLooksDown_hasItsDirectionAndTheTimeOfThePicture() {
    kit.with("MOUNTED PITCH", -Math.PI / 2.0).with("DELAY", 0.1);
    Point axis = Point.of(0.0, Math.sqrt(0.5), -Math.sqrt(0.5)); // to the left and, up, ahead
    kit.start(
        context ->
            new ObjectDetectorSensor(
                context,
                now ->
                    Optional.of(
                        new ObjectDetector.Detections(
                            now,
                            List.of(
                                new ObjectDetector.Detection(
                                    "path marker", 0, 0, 2, 0.01, 0.1, 0, Optional.of(axis)))))));
    kit.advance(0.5);

    PathMarker marker = (PathMarker) kit.latest(Channels.SENSED_OBJECTS).orElseThrow();
    assertThat(marker.z()).as("down").isCloseTo(2.0, within(1e-9));
    assertThat(marker.psi()).as("to the left").isCloseTo(Math.PI / 4.0, within(1e-9));
    assertThat(marker.timestamp()).hasValue(Clock.micros(kit.nowS()) - 100_000L);
  }

  @Test
  void step_goalSeeksBuoys_obstaclesAreStillPublished() {
    start();
    seek("red buoy");

    assertThat(typesSeen()).containsExactly("red buoy", "white pole");
  }

  @Test
  void step_onlySought_publishesWhatTheGoalNames() {
    kit.with("ONLY SOUGHT", true);
    start();
    seek("red buoy");

    assertThat(typesSeen()).containsExactly("red buoy");
  }

  @Test
  void step_onlySoughtWithoutGoals_publishesEverything() {
    kit.with("ONLY SOUGHT", true);
    start();

    assertThat(typesSeen()).containsExactly("red buoy", "white pole");
  }

  private static final class TwoThings implements ObjectDetector {
    @Override
    public Optional<Detections> read(long nowMicros) {
      return Optional.of(
          new Detections(
              nowMicros,
              List.of(
                  new Detection("red buoy", Math.PI / 2.0, 0.0, 10.0, 0.01, 0.5, 0.2),
                  new Detection("white pole", 0.0, 0.0, 5.0, 0.01, 0.25, 0.05))));
    }
  }
}
