package org.u2sa.vision.survey;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.u2sa.device.CameraSensor;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.service.ServiceContext;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.world.modeller.PoseHistory;

/**
 * A camera that looks down, while a search area is current: publishes which ground each image shows,
 * and the targets that it finds. In: state, goals. Out: sensed-objects. Thesis 4.4.1.1, 4.4.1.3.
 */
public final class SurveyCamera extends CameraSensor {
  private static final int MAX_WAITING = 8; // images for the state of their time
  private static final long GAP_MICROS = Clock.micros(0.5);

  private final PoseHistory poses = new PoseHistory();
  private final Deque<CameraFrame> waiting = new ArrayDeque<>();
  private final CameraMount mount;
  private Optional<SearchArea> area = Optional.empty();
  private long images;
  private long withoutState;

  /** Launcher constructor: opens the configured camera. */
  public SurveyCamera(ServiceContext context) {
    super(context, "SurveyCamera");
    mount = listen();
  }

  /** Uses the given camera, e.g. a simulated one. */
  public SurveyCamera(ServiceContext context, Camera camera) {
    super(context, "SurveyCamera", camera);
    mount = listen();
  }

  private CameraMount listen() {
    subscribe(Channels.STATE, this::onState);
    subscribe(Channels.GOALS, this::onGoals);
    return CameraMount.of(settings(MountingPose.class).get(), 0.0);
  }

  private void onGoals(GoalList goals) {
    area = Optional.empty();
    for (GoalInformation goal : goals.goals()) {
      if (goal instanceof SearchArea) {
        area = Optional.of((SearchArea) goal);
      }
    }
  }

  private void onState(StateInformation state) {
    poses.add(state);
    while (!waiting.isEmpty() && waiting.peek().measuredAtMicros() <= poses.newestMicros()) {
      CameraFrame frame = waiting.remove();
      Optional<StateInformation> then = poses.at(frame.measuredAtMicros(), GAP_MICROS);
      if (area.isPresent() && then.filter(SurveyCamera::isPlaced).isPresent()) {
        see(frame, then.get(), area.get());
      } else {
        withoutState += area.isPresent() ? 1 : 0;
      }
    }
    remark("IMAGES", images + (withoutState == 0 ? "" : ", " + withoutState + " without a state"));
  }

  private static boolean isPlaced(StateInformation state) {
    return state.referenceFrame().equals(ReferenceFrame.GLOBAL)
        && state.z().isPresent()
        && state.phi().isPresent()
        && state.theta().isPresent();
  }

  @Override
  protected void look(CameraFrame frame) {
    if (frame.intrinsics().isEmpty()) {
      trouble("an image of " + frame + " without the geometry of its lens");
      return;
    }
    if (waiting.size() >= MAX_WAITING) {
      waiting.remove();
      withoutState++;
    }
    waiting.add(frame);
  }

  private void see(CameraFrame frame, StateInformation state, SearchArea current) {
    AerialView view = new AerialView(frame, mount, state, current.ground());
    Optional<ImageFootprint> shown = view.footprint(++images);
    if (shown.isEmpty()) {
      return;
    }
    ImageFootprint footprint = shown.get();
    footprint.sensorName(sensorName());
    footprint.level(ObjectLevel.HINDRANCE);
    footprint.timestamp(frame.measuredAtMicros());
    publish(Channels.SENSED_OBJECTS, footprint);
  }
}
