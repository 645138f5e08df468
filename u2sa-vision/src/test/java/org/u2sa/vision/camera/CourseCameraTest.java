package org.u2sa.vision.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.testkit.ServiceKit;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.lens.CalibrationFile;
import org.u2sa.vision.lens.LensCalibration;

class CourseCameraTest {
  private static final double DOWN = 0.4;
  private static final MountingPose MOUNTED = new MountingPose(0.2, 0.0, -1.1, 0.0, -DOWN, 0.0);
  private static final LensCalibration LENS = LensCalibration.ofView(320, 240, 1.5);
  private static final CameraFrame LANE = lane().picture(view(0.0, 0.0), 1);

  private final ServiceKit kit = new ServiceKit();
  private final ShownPicture camera = new ShownPicture();
  @TempDir Path folder;

  /** A camera that sees what a test shows it. */
  private static final class ShownPicture implements Camera {
    private volatile Optional<CameraFrame> shown = Optional.empty();

    @Override
    public Optional<CameraFrame> read(long nowMicros) {
      return shown;
    }

    @Override
    public boolean isConnected() {
      return true;
    }

    @Override
    public String trouble() {
      return "";
    }

    @Override
    public void close() {
      shown = Optional.empty();
    }
  }

  @BeforeEach
  void mount() {
    kit.with("MOUNTED X", MOUNTED.x()).with("MOUNTED Z", MOUNTED.z()).with("MOUNTED PITCH", -DOWN);
  }

  @AfterEach
  void end() {
    kit.close();
  }

  private static GroundView view(double roll, double pitch) {
    return new GroundView(LENS, CameraMount.of(MOUNTED, 0.0), roll, pitch);
  }

  private List<ObjectDescription> seen(PaintedScene scene, double roll, double pitch) {
    kit.start(context -> new CourseCamera(context, camera));
    kit.advance(0.1);
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED);
    state.phi(roll).theta(pitch).timestamp(kit.clock().micros());
    kit.publish(Channels.STATE, state);
    CameraFrame drawn = scene.picture(view(roll, pitch), 1);
    camera.shown =
        Optional.of(
            new CameraFrame(
                kit.clock().micros(),
                drawn.width(),
                drawn.height(),
                drawn.format(),
                drawn.pixels(),
                drawn.intrinsics()));
    kit.advance(0.1);
    return kit.published(Channels.SENSED_OBJECTS);
  }

  private CameraFrame show(long micros) {
    CameraFrame frame =
        new CameraFrame(
            micros, LANE.width(), LANE.height(), LANE.format(), LANE.pixels(), LANE.intrinsics());
    camera.shown = Optional.of(frame);
    kit.advance(0.1);
    return frame;
  }

  private static PaintedScene lane() {
    return new PaintedScene().line(Point.of(0.5, -1.2, 0.0), Point.of(6.5, -1.2, 0.0), 0.0762, 1.0);
  }

  @Test
  void look_lineToTheLeft_isPublishedWhereItIsInBody() {
    List<ObjectDescription> objects = seen(lane(), 0.0, 0.0);
    assertThat(objects)
        .isNotEmpty()
        .allSatisfy(each -> assertThat(each).isInstanceOf(PolyLine.class));
    for (ObjectDescription object : objects) {
      assertThat(object.objectType()).isEqualTo("white line");
      assertThat(object.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
      assertThat(object.timestamp()).hasValue(camera.shown.orElseThrow().measuredAtMicros());
      ((PolyLine) object)
          .points()
          .forEach(point -> assertThat(point.y()).isBetween(1.2 - 0.08, 1.2 + 0.08));
    }
  }

  @Test
  void look_vehicleRolledAndPitched_lineIsWhereItIsOnTheGround() {
    double roll = 0.06;
    double pitch = -0.05;
    List<ObjectDescription> objects = seen(lane(), roll, pitch);
    assertThat(objects).isNotEmpty();
    GroundView view = view(roll, pitch);
    for (ObjectDescription object : objects) {
      for (Point point : ((PolyLine) object).points()) {
        Point level = view.toLevel(point);
        assertThat(level.y()).isBetween(-1.2 - 0.08, -1.2 + 0.08);
        assertThat(level.z()).isBetween(-0.01, 0.01);
      }
    }
  }

  @Test
  void look_fromTheTopOfARamp_lineLiesBetweenItsHeightAndTheGroundBeyond() {
    kit.with("SLOPE ABOVE", 0.035);
    kit.start(context -> new CourseCamera(context, camera));
    double climbed = 2.0 * Math.sin(0.15);
    for (int i = 0; i <= 40; i++) {
      StateInformation state = new StateInformation().theta(0.15).psi(0.0).phi(0.0);
      state.xDot(0.0).yDot(1.0).timestamp(kit.clock().micros());
      kit.publish(Channels.STATE, state);
      kit.advance(0.05);
    }
    StateInformation top = new StateInformation().theta(0.0).psi(0.0).phi(0.0);
    top.xDot(0.0).yDot(1.0).timestamp(kit.clock().micros());
    kit.publish(Channels.STATE, top);

    show(kit.clock().micros());

    double wider = (1.1 + 0.5 * climbed) / 1.1;
    List<ObjectDescription> objects = kit.published(Channels.SENSED_OBJECTS);
    assertThat(objects).isNotEmpty();
    for (ObjectDescription object : objects) {
      for (Point point : ((PolyLine) object).points()) {
        assertThat(point.y()).isBetween(1.2 * wider - 0.08, 1.2 * wider + 0.08);
      }
      assertThat(object.motion().sigma().orElseThrow().x())
          .isGreaterThan(object.x() * climbed / Math.sqrt(12.0) / (1.1 + 0.5 * climbed) * 0.7);
    }
  }

  @Test
  void look_pieces_areLessCertainTheFartherTheyAre() {
    List<ObjectDescription> objects = seen(lane(), 0.0, 0.0);
    assertThat(objects).hasSizeGreaterThan(1);
    for (int i = 1; i < objects.size(); i++) {
      assertThat(objects.get(i).x()).isGreaterThan(objects.get(i - 1).x());
      assertThat(objects.get(i).motion().sigma().orElseThrow().x())
          .isGreaterThan(objects.get(i - 1).motion().sigma().orElseThrow().x());
    }
  }

  @Test
  void look_barrel_isACylinderOfItsTypeWhereItStands() {
    List<ObjectDescription> objects =
        seen(new PaintedScene().barrel(Point.of(4.0, 1.0, 0.0)), 0.0, 0.0);
    assertThat(objects).hasSize(1);
    Cylinder barrel = (Cylinder) objects.get(0);
    assertThat(barrel.objectType()).isEqualTo("barrel");
    assertThat(barrel.x()).isBetween(3.75, 4.25);
    assertThat(barrel.y()).isBetween(-1.1, -0.9);
    assertThat(barrel.z()).isBetween(-0.55, -0.45);
    assertThat(barrel.radius()).isEqualTo(0.3);
  }

  @Test
  void look_nothingInView_saysSo() {
    List<ObjectDescription> objects = seen(new PaintedScene(), 0.0, 0.0);
    assertThat(objects).hasSize(1);
    assertThat(objects.get(0).objectType()).isEqualTo("nothing");
    assertThat(objects.get(0).level()).contains(ObjectLevel.HINDRANCE);
    assertThat(objects.get(0).timestamp()).hasValue(camera.shown.orElseThrow().measuredAtMicros());
  }

  @Test
  void look_calibrationOfAnotherShape_isTroubleNotAnEnd() throws Exception {
    Path file = folder.resolve("camera.xml");
    CalibrationFile.write(LensCalibration.ofView(640, 360, 1.5), file);
    kit.with("CALIBRATION", file.toString());
    assertThat(seen(lane(), 0.0, 0.0)).isEmpty();
    kit.advance(2.0);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElseThrow())
        .contains("640 x 360")
        .contains("320 x 240");
  }

  @Test
  void look_withoutImageEvery_publishesNoPicture() {
    assertThat(seen(lane(), 0.0, 0.0)).isNotEmpty();
    assertThat(kit.published(Channels.IMAGES)).isEmpty();
  }

  @Test
  void look_imageEvery_publishesPicturesThatFarApart() throws Exception {
    kit.with("IMAGE EVERY", 0.5).with("SENSOR NAME", "Mast");
    kit.start(context -> new CourseCamera(context, camera));
    for (long micros : new long[] {1_000_000, 1_400_000, 1_500_000, 1_999_999, 2_100_000}) {
      show(micros);
    }

    List<CameraImage> images = kit.published(Channels.IMAGES);
    assertThat(images)
        .extracting(image -> image.timestamp().orElseThrow())
        .containsExactly(1_000_000L, 1_500_000L, 2_100_000L);
    CameraImage image = images.get(0);
    assertThat(image.sensorName()).isEqualTo("Mast");
    assertThat(image.format()).isEqualTo("jpeg");
    BufferedImage read = ImageIO.read(new ByteArrayInputStream(image.data().toBytes()));
    assertThat(read.getWidth()).isEqualTo(320).isEqualTo((int) image.width());
    assertThat(read.getHeight()).isEqualTo(240).isEqualTo((int) image.height());
  }

  /** A camera's pictures are never to the microsecond where they would fit. */
  @Test
  void look_picturesJustBeforeTheirTime_keepThePaceOnAverage() {
    kit.with("IMAGE EVERY", 0.5);
    kit.start(context -> new CourseCamera(context, camera));
    for (int i = 0; i <= 50; i++) {
      show(1_000_000 + i * 99_999L);
    }

    assertThat(kit.published(Channels.IMAGES)).hasSize(10);
  }

  @Test
  void look_cameraSlowerThanThat_publishesAll() {
    kit.with("IMAGE EVERY", 0.5);
    kit.start(context -> new CourseCamera(context, camera));
    for (int i = 0; i < 8; i++) {
      show(1_000_000 + i * 800_000L);
    }

    assertThat(kit.published(Channels.IMAGES)).hasSize(8);
  }

  @Test
  void look_clockSetBack_publishesTheNextPicture() {
    kit.with("IMAGE EVERY", 0.5);
    kit.start(context -> new CourseCamera(context, camera));
    show(9_000_000);
    show(8_000_000);

    assertThat(kit.published(Channels.IMAGES)).hasSize(2);
  }

  @Test
  void look_pictureTooLargeForAMessage_isTroubleAndIsReadAllTheSame() {
    kit.with("IMAGE EVERY", 0.5);
    kit.start(context -> new CourseCamera(context, camera));
    byte[] large = new byte[1 << 20];
    camera.shown =
        Optional.of(
            new CameraFrame(
                1_000_000, 4000, 3000, CameraFrame.PixelFormat.JPEG, large, Optional.empty()));
    kit.advance(2.0);

    assertThat(kit.published(Channels.IMAGES)).isEmpty();
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElseThrow())
        .contains("JPEG");
  }

  @Test
  void construction_cameraBelowTheGround_isRefused() {
    kit.with("MOUNTED Z", 0.5);
    assertThatThrownBy(() -> kit.start(context -> new CourseCamera(context, camera)))
        .hasMessageContaining("MOUNTED Z 0.50 m")
        .hasMessageContaining("not above the ground");
  }
}
