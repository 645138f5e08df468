package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.Renderer;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.vision.camera.CourseSight;
import org.u2sa.vision.camera.CourseVariables;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.lens.LensCalibration;

/** What is seen of rendered courses in light of all kinds, from anywhere beside a line. */
@Tag("long")
class SightCampaignTest {
  private static final int COURSES = 12;
  private static final int PICTURES = 8; // of each
  private static final double OBJECTS_M = 8.0;
  private static final double TILT_ERROR = 0.004; // of the estimated attitude, 1 sigma [rad]
  private static final double CLEAR_M = 1.1;

  private final ColourLens lens = ColourLens.mast();

  @Test
  void look_randomCoursesAndLight_linesAreFoundAndNothingElse() {
    CourseVariables settings =
        XmlConfiguration.inMemory("the campaign", Map.of()).settings(CourseVariables.class).get();
    CourseSight sight = new CourseSight(settings);
    SightScore score =
        new SightScore(settings.nearest(), settings.farthest(), settings.toEachSide(), OBJECTS_M);
    for (long seed = 11; seed < 11 + COURSES; seed++) {
      Course course = CourseGenerator.course(seed, Ramps.NONE); // figures are of level ground
      Random random = new Random(7919L * seed);
      Scenery scenery = new Scenery(course.objects(), Light.random(random), seed);
      for (int i = 0; i < PICTURES; i++) {
        look(course, scenery, random, sight, score);
      }
    }
    assertThat(score.linePrecision()).as(score.toString()).isGreaterThan(0.98);
    assertThat(score.lineRecall()).as(score.toString()).isGreaterThan(0.93);
    assertThat(score.lineError(0.95)).as(score.toString()).isLessThan(0.2);
    assertThat(score.recall("barrel")).as(score.toString()).isGreaterThan(0.75);
  }

  private void look(
      Course course, Scenery scenery, Random random, CourseSight sight, SightScore score) {
    VehicleTruth truth = beside(course, random);
    Renderer renderer = new Renderer(lens, scenery, new NoiseStreams(random.nextLong()));
    CameraFrame frame =
        new CameraFrame(
            0L,
            lens.width(),
            lens.height(),
            PixelFormat.RGB24,
            renderer.picture(truth),
            Optional.of(lens.intrinsics()));
    CameraMount mount =
        CameraMount.of(
            new MountingPose(lens.forwardM(), lens.leftM(), -lens.upM(), 0.0, -lens.downRad(), 0.0),
            0.0);
    double roll = truth.attitude().phi() + TILT_ERROR * random.nextGaussian();
    double pitch = truth.attitude().theta() + TILT_ERROR * random.nextGaussian();
    LensCalibration calibration =
        LensCalibration.pinhole(lens.width(), lens.height(), lens.intrinsics());
    score.add(course.objects(), truth, sight.look(frame, calibration, mount, roll, pitch));
  }

  /** Somewhere beside a lane's boundary, turned about along it, rolling, pitching and turning. */
  private static VehicleTruth beside(Course course, Random random) {
    while (true) {
      List<Point> line =
          course.boundaries().get(random.nextInt(course.boundaries().size())).points();
      int at = random.nextInt(line.size() - 1);
      Point from = line.get(at);
      Point to = line.get(at + 1);
      double along = Math.atan2(to.x() - from.x(), to.y() - from.y());
      double aside = (random.nextBoolean() ? 1.0 : -1.0) * (0.7 + 1.2 * random.nextDouble());
      double heading = along + 0.5 * random.nextGaussian() + (random.nextBoolean() ? 0.0 : Math.PI);
      Point place =
          Point.of(from.x() + aside * Math.cos(along), from.y() - aside * Math.sin(along), 0.0);
      VehicleTruth truth =
          new VehicleTruth(
              0.0,
              place,
              new Attitude(
                  0.02 * random.nextGaussian(),
                  0.02 * random.nextGaussian(),
                  (heading + 4.0 * Math.PI) % (2.0 * Math.PI)),
              Point.of(1.5 * Math.sin(heading), 1.5 * Math.cos(heading), 0.0),
              Point.of(0.0, 0.0, 0.4 * random.nextGaussian()),
              Point.ORIGIN);
      boolean isClear =
          course.objects().stream()
              .filter(object -> object instanceof Cylinder || object instanceof Box)
              .allMatch(object -> object.distanceTo(place) > CLEAR_M);
      if (isClear) {
        return truth;
      }
    }
  }
}
