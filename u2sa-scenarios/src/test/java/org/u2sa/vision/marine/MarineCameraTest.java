package org.u2sa.vision.marine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.WaterLook;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.ServiceKit;

/** The service: messages, and what the current goals make it look for. */
class MarineCameraTest {
  private static final double STEP_S = 0.1;

  private final ServiceKit kit = new ServiceKit();
  private final CameraFrame red = picture();

  private static CameraFrame picture() {
    Buoy buoy = RenderedBuoys.at(new Buoy().radius(0.25).colour(Colour.RED), 8.0, 2.0, 0.05);
    VehicleTruth truth =
        new VehicleTruth(
            1.0,
            Point.of(0.0, 0.0, 0.9),
            new Attitude(0.0, 0.0, Math.PI / 2.0),
            Point.ORIGIN,
            Point.ORIGIN,
            Point.ORIGIN);
    return RenderedBuoys.picture(List.of(buoy), WaterLook.open(3.0), Light.clear(), truth, 3L);
  }

  /** A camera that shows the same picture again and again. */
  private final class Repeating implements Camera {
    @Override
    public Optional<CameraFrame> read(long nowMicros) {
      return Optional.of(
          new CameraFrame(
              nowMicros, red.width(), red.height(), red.format(), red.pixels(), red.intrinsics()));
    }

    @Override
    public String trouble() {
      return "";
    }

    @Override
    public void close() {}
  }

  private MarineCamera camera(String... settings) {
    for (int i = 0; i < settings.length; i += 2) {
      kit.with(settings[i], settings[i + 1]);
    }
    return kit.start(context -> new MarineCamera(context, new Repeating()));
  }

  private List<ObjectDescription> afterGoals(GoalInformation... goals) {
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(goals)));
    kit.advance(STEP_S);
    int before = kit.published(Channels.SENSED_OBJECTS).size();
    kit.advance(STEP_S);
    List<ObjectDescription> all = kit.published(Channels.SENSED_OBJECTS);
    return all.subList(before, all.size());
  }

  @AfterEach
  void stop() {
    kit.close();
  }

  @Test
  void look_redBuoy_isPublishedInBody() {
    camera();
    kit.advance(STEP_S);
    kit.advance(STEP_S);

    Buoy seen = (Buoy) kit.published(Channels.SENSED_OBJECTS).get(0);
    assertThat(seen.colour()).contains(Colour.RED);
    assertThat(seen.objectType()).isEqualTo("red buoy");
    assertThat(seen.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    double sigma = seen.motion().sigma().orElseThrow().x();
    assertThat(seen.x()).isEqualTo(8.0, within(3.0 * sigma));
    assertThat(seen.y()).isEqualTo(2.0, within(3.0 * sigma)); // to the left
  }

  @Test
  void look_goalThatNeedsNoBuoy_processesNothing() {
    camera("KINDS BY GOAL", "Waypoint:");

    assertThat(afterGoals(new Waypoint().uid("1").x(0.0).y(0.0).horizontalThreshold(1.0)))
        .isEmpty();
    assertThat(afterGoals(new ObjectGoal().uid("2").objectType("red buoy").within(1.0)))
        .isNotEmpty();
    assertThat(afterGoals(new ObjectGoal().uid("3").objectType("hoop").within(1.0))).isEmpty();
  }

  @Test
  void look_alwaysBuoys_seesThemWhateverTheGoal() {
    camera("ALWAYS", "Buoy", "KINDS BY GOAL", "Waypoint:");

    assertThat(afterGoals(new Waypoint().uid("1").x(0.0).y(0.0).horizontalThreshold(1.0)))
        .isNotEmpty();
  }

  @Test
  void constructor_unknownKind_namesIt() {
    assertThatThrownBy(() -> camera("KINDS", "Buoy, Whale"))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("KINDS \"Whale\"");
  }
}
