package org.u2sa.vision.survey;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.CameraSensor;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.service.ServiceContext;
import org.u2sa.vision.camera.CameraImages;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.world.modeller.PoseHistory;

/**
 * A downward-looking camera, active while a search area or a goal with a photoDistance is current:
 * publishes the ground that each image shows, and afterwards the targets found. In a search area it
 * uses all images, otherwise one per photoDistance. In: state, goals. Out: sensed-objects,
 * survey-targets; images, for a mosaic, every IMAGE EVERY seconds if set; mission, orders for
 * closer looks if CLOSER LOOKS is set. Thesis 4.4.1.1, 4.4.1.3.
 */
public final class SurveyCamera extends CameraSensor {
  private record Variables(
      @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 0)
          @Description("Interval of JPEG pictures published on images; 0: none.")
          double imageEvery,
      @Variable(min = 1, max = 16, ifAbsent = 2)
          @Description("Camera pixels along each side merged into one pixel of these pictures.")
          int imageShrink,
      @Variable(ifAbsentText = "")
          @Description(
              "Height map of the ground, an Esri ASCII grid in degrees; without it search areas are level.")
          String terrain,
      @Variable(unit = "m", min = -500, max = 9000, ifAbsent = 0)
          @Description("Ground altitude for images outside a search area.")
          double groundAltitude,
      @Variable(unit = "rad", min = 0, max = 1.57, ifAbsent = 0)
          @Description(
              "Maximum roll and pitch that the camera's gimbal compensates; 0: the camera is fixed to the vehicle.")
          double gimbalLimit,
      @Variable(min = 0, max = 100, ifAbsent = 0)
          @Description(
              "Maximum number of unreadable targets per mission that get a closer look; on a secured broker the camera's account then needs the role operator.")
          int closerLooks,
      @Variable(min = 0.1, max = 1, ifAbsent = 0.6)
          @Description("Resolution of a closer look, as a share of the area's.")
          double closerResolution) {}

  private static final int MAX_WAITING = 8; // images waiting for the state of their time
  private static final double MIN_M = 0.7; // minimum size of a target
  private static final double MAX_M = 2.8;
  private static final double SIGMA_M = 2.0; // sigma of a ground position
  private static final String[] POINTS = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
  private static final long GAP_MICROS = Clock.micros(0.5);

  private final Settings<Variables> variables = settings(Variables.class);
  private final DistanceTrigger trigger = new DistanceTrigger();
  private final PoseHistory poses = new PoseHistory();
  private final Deque<CameraFrame> waiting = new ArrayDeque<>();
  private final CameraGimbal gimbal = new CameraGimbal(variables.get().gimbalLimit());
  private final CameraMount mount;
  private final TargetLog targets = new TargetLog();
  private final TargetModel model = TargetModel.shipped();
  private final Optional<CameraImages> pictures; // empty: not published
  private final Optional<HeightGrid> terrain;
  private final CloserLook closer = new CloserLook(variables.get().closerResolution());
  private int looks; // number of closer looks ordered
  private Optional<SearchArea> area = Optional.empty();
  private long images;
  private long withoutState;

  public SurveyCamera(ServiceContext context) {
    super(context, "SurveyCamera");
    mount = listen();
    pictures = pictures();
    terrain = HeightGrid.named(variables.get().terrain(), context.configuration()::resolve);
  }

  public SurveyCamera(ServiceContext context, Camera camera) {
    super(context, "SurveyCamera", camera);
    mount = listen();
    pictures = pictures();
    terrain = HeightGrid.named(variables.get().terrain(), context.configuration()::resolve);
  }

  private CameraMount listen() {
    subscribe(Channels.STATE, this::onState);
    subscribe(Channels.GOALS, this::onGoals);
    registerPublisher(SurveyTarget.CHANNEL);
    if (variables.get().closerLooks() > 0) {
      registerPublisher(Channels.MISSION);
    }
    return CameraMount.of(settings(MountingPose.class).get(), 0.0);
  }

  private Optional<CameraImages> pictures() {
    Variables showing = variables.get();
    if (showing.imageEvery() == 0.0) {
      return Optional.empty();
    }
    registerPublisher(Channels.IMAGES);
    return Optional.of(new CameraImages(sensorName(), showing.imageEvery(), showing.imageShrink()));
  }

  private void onGoals(GoalList goals) {
    boolean searched = area.isPresent() || trigger.isOn();
    Optional<SearchArea> before = area;
    area = Optional.empty();
    OptionalDouble distance = OptionalDouble.empty();
    for (GoalInformation goal : goals.goals()) {
      if (goal instanceof SearchArea) {
        area = Optional.of((SearchArea) goal);
      } else if (goal instanceof Waypoint waypoint && waypoint.photoDistance().isPresent()) {
        distance = waypoint.photoDistance();
      }
    }
    trigger.each(distance);
    if (searched && area.isEmpty() && (before.isPresent() || !trigger.isOn())) {
      report();
      List<Geodetic> unclear =
          targets.unclear(before.isPresent() ? variables.get().closerLooks() - looks : 0);
      if (!unclear.isEmpty()) {
        publish(
            Channels.MISSION,
            closer.order(
                before.get(), unclear, sensorName(), looks + 1, context().clock().micros()));
        looks += unclear.size();
      }
    }
  }

  private void report() {
    for (SurveyTarget target : targets.reports(SIGMA_M)) {
      target.sensorName(sensorName());
      log("target: " + String.join(", ", target.fields()));
      publish(SurveyTarget.CHANNEL, target);
    }
  }

  private void onState(StateInformation state) {
    poses.add(state);
    while (!waiting.isEmpty() && waiting.peek().measuredAtMicros() <= poses.newestMicros()) {
      CameraFrame frame = waiting.remove();
      Optional<StateInformation> then = poses.at(frame.measuredAtMicros(), GAP_MICROS);
      boolean isWanted = area.isPresent() || trigger.isOn();
      if (!isWanted || then.filter(SurveyCamera::isPlaced).isEmpty()) {
        withoutState += isWanted ? 1 : 0;
      } else if (area.isPresent()) {
        see(frame, gimbal.of(then.get()), area.get().ground());
      } else if (trigger.isDue(then.get())) {
        see(frame, gimbal.of(then.get()), variables.get().groundAltitude());
      }
    }
    remark("TARGETS", String.valueOf(targets.size()));
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

  private void see(CameraFrame frame, StateInformation state, double groundM) {
    AerialView view = new AerialView(frame, mount, state, groundM, terrain);
    Optional<ImageFootprint> shown = view.footprint(++images);
    if (shown.isEmpty()) {
      return;
    }
    ImageFootprint footprint = shown.get();
    footprint.uid("image " + images).objectType("image").sensorName(sensorName());
    footprint.level(ObjectLevel.HINDRANCE);
    footprint.timestamp(frame.measuredAtMicros());
    publish(Channels.SENSED_OBJECTS, footprint);
    show(frame);
    if (frame.format() == CameraFrame.PixelFormat.RGB24) {
      double pixelM = view.resolutionM(0.5 * frame.width(), 0.5 * frame.height());
      for (TargetPatch patch : TargetFinder.in(frame, MIN_M / pixelM, MAX_M / pixelM)) {
        find(frame, view, patch);
      }
    }
  }

  private void show(CameraFrame frame) {
    try {
      pictures.flatMap(each -> each.of(frame)).ifPresent(each -> publish(Channels.IMAGES, each));
    } catch (IllegalArgumentException e) {
      trouble("a picture of " + frame + " to publish: " + e.getMessage());
    }
  }

  private void find(CameraFrame frame, AerialView view, TargetPatch patch) {
    Optional<Geodetic> place = view.ground(patch.column(), patch.row());
    if (place.isEmpty()) {
      return;
    }
    TargetColours colours = new TargetColours(frame, patch);
    TargetModel.Read letter =
        colours.hasLetter() ? model.letter(patch, colours.ink()) : new TargetModel.Read("", 0.0);
    targets.see(
        place.get(),
        List.of(
            model.shape(TargetFeatures.outline(patch)),
            colours.shapeColour(),
            letter.name(),
            colours.hasLetter() ? colours.letterColour() : "",
            letter.name().isEmpty() ? "" : compass(letter.upRad() + view.upRad())));
  }

  private static String compass(double rad) {
    return POINTS[Math.floorMod((int) Math.round(rad / (Math.PI / 4.0)), POINTS.length)];
  }
}
