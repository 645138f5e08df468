package org.u2sa.scenarios.suas;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.mission.Mission;
import org.u2sa.report.mosaic.MosaicGrid;
import org.u2sa.report.mosaic.SurveyMosaic;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.Terrain;
import org.u2sa.testkit.ServiceKit;
import org.u2sa.vision.survey.CameraGimbal;
import org.u2sa.vision.survey.SurveyCamera;
import org.u2sa.vision.survey.SurveyTarget;

/** Targets of fields that the model was not made from, each painted in three images. */
class SurveyCameraTest {
  private static final SurveyPictures.Optics OPTICS =
      new SurveyPictures.Optics(2.0, 320, 320, SurveyPictures.USUAL.focalPx());
  private static final double UP_M = 52.0;

  @TempDir private Path folder;
  private CameraFrame frame; // the newest
  private Optional<FieldGround> ground = Optional.empty();
  private Optional<CameraGimbal> gimbal = Optional.empty();
  private Attitude banked = new Attitude(0.03, 0.08, 0.0);

  private Camera camera() {
    return new Camera() {
      @Override
      public Optional<CameraFrame> read(long nowMicros) {
        return Optional.ofNullable(frame);
      }

      @Override
      public void close() {}
    };
  }

  private static SearchArea area() {
    Point corner = SuasField.ORIGIN.point();
    return new SearchArea()
        .corners(
            List.of(
                corner,
                corner.plus(Point.of(1e-3, 0.0, 0.0)),
                corner.plus(Point.of(0.0, 1e-3, 0.0))))
        .resolution(0.05)
        .ground(SuasField.ORIGIN.altitudeM())
        .uid("search");
  }

  /** Flies over a target three times; the report. */
  private List<SurveyTarget> look(ServiceKit kit, SuasTarget target, int image) {
    return look(kit, area(), target, image, 3);
  }

  /** Flies over a target in a search area some times; the report. */
  private List<SurveyTarget> look(
      ServiceKit kit, SearchArea area, SuasTarget target, int image, int times) {
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(area)));
    for (int i = 0; i < times; i++) {
      double psi = 0.7 * (image + i);
      Point at = Point.of(target.eastM() + 2.0 * i - 2.0, target.northM() + 1.0, UP_M);
      VehicleTruth truth =
          new VehicleTruth(
              0.5 * (image + i),
              at,
              new Attitude(banked.phi(), banked.theta(), psi),
              Point.ORIGIN,
              Point.ORIGIN,
              Point.ORIGIN);
      VehicleTruth seen = gimbal.map(each -> SurveyPictures.levelled(each, truth)).orElse(truth);
      byte[] pixels = new FieldPainter(List.of(target), OPTICS, 77L + image, ground).picture(seen);
      frame =
          new CameraFrame(
              kit.clock().micros(),
              OPTICS.width(),
              OPTICS.height(),
              CameraFrame.PixelFormat.RGB24,
              pixels,
              Optional.of(OPTICS.intrinsics()));
      Geodetic place = SuasField.plane().at(at.x(), at.y(), at.z());
      StateInformation state =
          new StateInformation()
              .referenceFrame(ReferenceFrame.GLOBAL)
              .x(place.longitudeDeg())
              .y(place.latitudeDeg())
              .z(place.altitudeM())
              .phi(banked.phi())
              .theta(banked.theta())
              .psi(Math.IEEEremainder(psi, 2.0 * Math.PI));
      state.timestamp(kit.clock().micros());
      kit.advance(0.2);
      kit.publish(Channels.STATE, state.copy());
      kit.advance(0.3);
      StateInformation later = state.copy();
      later.timestamp(kit.clock().micros());
      kit.publish(Channels.STATE, later);
    }
    int before = kit.published(SurveyTarget.CHANNEL).size();
    kit.publish(Channels.GOALS, new GoalList());
    List<SurveyTarget> all = kit.published(SurveyTarget.CHANNEL);
    return all.subList(before, all.size());
  }

  @Test
  void look_targetsOfUnseenFields_nineOfTenHaveFourFieldsAndNoneIsFalse() {
    try (ServiceKit kit = new ServiceKit().with("MOUNTED PITCH", -Math.PI / 2.0)) {
      kit.start(context -> new SurveyCamera(context, camera()));
      int targets = 0;
      int right = 0;
      int image = 0;
      for (long seed = 500; seed < 504; seed++) {
        for (SuasTarget target : SuasFieldGenerator.field(seed, 0.0).targets()) {
          List<SurveyTarget> reports = look(kit, target, image);
          image += 3;
          targets++;
          assertThat(reports.size()).isLessThanOrEqualTo(1);
          right += reports.size() == 1 && isRight(reports.get(0), target) ? 1 : 0;
        }
      }
      assertThat(kit.published(Channels.SENSED_OBJECTS))
          .hasOnlyElementsOfType(ImageFootprint.class)
          .hasSizeGreaterThan(targets);
      assertThat((double) right / targets).isGreaterThanOrEqualTo(0.9);
    }
  }

  /** On a fixed camera, a bank of 24° moves the target out of the image. */
  @ParameterizedTest
  @CsvSource({"0.0, 0", "0.38, 1", "0.6, 1"})
  void look_turning_isSeenIfAGimbalKeepsTheCameraNearlyLevel(double limitRad, int reports) {
    SuasTarget target = SuasFieldGenerator.field(506, 0.0).targets().get(0);
    banked = new Attitude(0.42, -0.1, 0.0);
    gimbal = Optional.of(new CameraGimbal(limitRad));
    try (ServiceKit kit = new ServiceKit().with("MOUNTED PITCH", -Math.PI / 2.0)) {
      kit.with("GIMBAL LIMIT", limitRad);
      kit.start(context -> new SurveyCamera(context, camera()));

      List<SurveyTarget> found = look(kit, target, 9);

      assertThat(found).hasSize(reports).allMatch(each -> isRight(each, target));
      found.forEach(
          each -> {
            Point at = SuasField.plane().point(new Geodetic(each.x(), each.y(), each.z()));
            assertThat(at.distanceTo(Point.of(target.eastM(), target.northM(), at.z())))
                .isLessThan(1.0);
          });
    }
  }

  /** Seen once, it is not reported, but looked at again; then it is, and not looked at any more. */
  @Test
  void look_targetSeenOnce_isLookedAtAgainByAnAreaAroundItThenReported() throws IOException {
    SuasTarget target = SuasFieldGenerator.field(506, 0.0).targets().get(0);
    try (ServiceKit kit = new ServiceKit().with("MOUNTED PITCH", -Math.PI / 2.0)) {
      kit.with("CLOSER LOOKS", 2);
      kit.start(context -> new SurveyCamera(context, camera()));

      assertThat(look(kit, area(), target, 9, 1)).isEmpty();

      MissionOrder order = (MissionOrder) kit.published(Channels.MISSION).get(0);
      assertThat(order.action()).isEqualTo(MissionAction.INSERT);
      assertThat(order.now()).isTrue();
      SearchArea closer = areaOf(order);
      assertThat(closer.fault()).isEmpty();
      assertThat(closer.resolution()).isEqualTo(0.6 * area().resolution());
      List<Point> corners =
          closer.corners().stream()
              .map(at -> SuasField.plane().point(new Geodetic(at.x(), at.y(), 0.0)))
              .toList();
      assertThat(SuasField.isInside(corners, target.eastM(), target.northM())).isTrue();

      List<SurveyTarget> found = look(kit, closer, target, 20, 3);

      assertThat(found).hasSize(1).allMatch(each -> isRight(each, target));
      assertThat(kit.published(Channels.MISSION)).hasSize(1);
    }
  }

  private SearchArea areaOf(MissionOrder order) throws IOException {
    Path file = Files.writeString(folder.resolve("order.xml"), order.goals().orElseThrow());
    return (SearchArea) Mission.load(file).goals().get(0);
  }

  @Test
  void look_imagesPublished_makeAMosaicWithColoursAndPlacesOfTheTruth() {
    SuasTarget target = SuasFieldGenerator.field(505, 0.0).targets().get(0);
    Point middle = Point.of(target.eastM(), target.northM(), 0.0);
    List<Point> square =
        List.of(
            middle.plus(Point.of(-3.0, -3.0, 0.0)),
            middle.plus(Point.of(3.0, -3.0, 0.0)),
            middle.plus(Point.of(3.0, 3.0, 0.0)),
            middle.plus(Point.of(-3.0, 3.0, 0.0)));
    List<Geodetic> corners =
        square.stream().map(at -> SuasField.plane().at(at.x(), at.y(), 0.0)).toList();
    SurveyMosaic mosaic = new SurveyMosaic(MosaicGrid.around(corners, 0.1, 2.0));
    ground = Optional.of(new FieldGround(square, List.of(target), Terrain.flat(), 505));
    try (ServiceKit kit =
        new ServiceKit().with("MOUNTED PITCH", -Math.PI / 2.0).with("IMAGE EVERY", 0.5)) {
      kit.start(context -> new SurveyCamera(context, camera()));
      look(kit, target, 3);
      kit.published(Channels.SENSED_OBJECTS).forEach(mosaic::take);
      assertThat(kit.published(Channels.IMAGES)).hasSize(3).allMatch(each -> each.width() == 160);
      kit.published(Channels.IMAGES).forEach(mosaic::take);
    }
    assertThat(mosaic.used()).isEqualTo(3);
    Map<String, Double> figures =
        MosaicScore.of(mosaic, square, List.of(target), ground.orElseThrow());
    assertThat(figures.get("mosaicShown")).isEqualTo(1.0);
    assertThat(figures.get("mosaicTargetOffsetM")).isLessThan(0.1);
    assertThat(figures.get("mosaicColourError")).isLessThan(6.0);
  }

  /** Straight on at 20 m/s, an image each 0.5 s. */
  @Test
  void look_photoDistance_recordsAnImageAtOnceAndEachTimeItHasBeenFlown() {
    try (ServiceKit kit = new ServiceKit().with("MOUNTED PITCH", -Math.PI / 2.0)) {
      kit.with("GROUND ALTITUDE", SuasField.ORIGIN.altitudeM());
      kit.start(context -> new SurveyCamera(context, camera()));
      Waypoint goal = new Waypoint().uid("1").x(0).y(0).horizontalThreshold(15.0);
      kit.publish(Channels.GOALS, new GoalList().goals(List.of(goal.copy().photoDistance(35.0))));
      for (int i = 0; i <= 40; i++) {
        frame =
            new CameraFrame(
                kit.clock().micros(),
                OPTICS.width(),
                OPTICS.height(),
                CameraFrame.PixelFormat.JPEG,
                new byte[] {1},
                Optional.of(OPTICS.intrinsics()));
        Geodetic place = SuasField.plane().at(10.0 * i, 0.0, UP_M);
        StateInformation state = new StateInformation().phi(0.0).theta(0.0).psi(0.0);
        state.x(place.longitudeDeg()).y(place.latitudeDeg()).z(place.altitudeM());
        state.timestamp(kit.clock().micros());
        kit.advance(0.25);
        kit.publish(Channels.STATE, state.copy());
        kit.advance(0.25);
      }

      // 400 m: the first at once, then after each 35 m, on average
      assertThat(kit.published(Channels.SENSED_OBJECTS)).hasSize(12);
      kit.publish(Channels.GOALS, new GoalList().goals(List.of(goal)));
      assertThat(kit.published(SurveyTarget.CHANNEL)).isEmpty();
    }
  }

  private static boolean isRight(SurveyTarget report, SuasTarget target) {
    List<String> truth =
        List.of(
            target.shape(),
            target.colour(),
            target.letter(),
            target.letterColour(),
            target.orientation());
    int fields = 0;
    for (int i = 0; i < truth.size(); i++) {
      fields += truth.get(i).equals(report.fields().get(i)) ? 1 : 0;
    }
    Point at = SuasField.plane().point(new Geodetic(report.x(), report.y(), report.z()));
    double away = Math.hypot(at.x() - target.eastM(), at.y() - target.northM());
    return fields >= 3 && away <= 15.0;
  }
}
