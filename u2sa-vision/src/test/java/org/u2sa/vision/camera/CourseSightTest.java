package org.u2sa.vision.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.device.MountingPose;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.line.PaintFinder.PaintedLine;
import org.u2sa.vision.object.ObjectKind;
import org.u2sa.vision.object.SeenObject;

/** What is seen in drawn pictures with a known truth. */
class CourseSightTest {
  private static final double WIDTH = 0.0762;
  private static final CameraMount MOUNT =
      CameraMount.of(new MountingPose(0.0, 0.0, -1.1, 0.0, -0.4, 0.0), 0.0);
  private static final LensCalibration LENS = LensCalibration.ofView(320, 240, 1.4);
  private static final GroundView VIEW = new GroundView(LENS, MOUNT, 0.0, 0.0);

  private final CourseSight sight =
      new CourseSight(
          XmlConfiguration.inMemory("the test", Map.of("FARTHEST", 5.0, "TO EACH SIDE", 2.5))
              .settings(CourseVariables.class)
              .get());

  private Seen seen(PaintedScene scene) {
    return sight.look(scene.picture(VIEW, 5), LENS, MOUNT, 0.0, 0.0);
  }

  private static Point at(double forward, double right) {
    return Point.of(forward, right, 0.0);
  }

  private static PaintedScene lane(double paint) {
    return new PaintedScene()
        .line(at(0.5, -0.8), at(5.5, -0.8), WIDTH, paint)
        .line(at(0.5, 0.9), at(5.5, 0.9), WIDTH, paint);
  }

  private static double length(List<PaintedLine> lines) {
    return lines.stream().mapToDouble(PaintedLine::lengthM).sum();
  }

  private static List<Point> points(Seen seen) {
    List<Point> points = new ArrayList<>();
    seen.lines().forEach(line -> points.addAll(line.points()));
    return points;
  }

  @ParameterizedTest(name = "light {0}, noise {1}, paint {2}, shade {3}, {4}")
  @CsvSource({
    "1.0, 0, 1.0, 1.0, colour",
    "0.35, 3, 1.0, 1.0, colour",
    "1.6, 3, 1.0, 1.0, colour", // overexposed: paint is clipped
    "1.0, 12, 1.0, 1.0, colour",
    "1.0, 3, 0.45, 1.0, colour", // worn
    "1.0, 3, 1.0, 0.3, colour", // a shadow across both lines
    "1.0, 3, 1.0, 0.3, grey",
    "0.35, 4, 1.0, 0.5, grey"
  })
  void look_laneInAllLights_isSeenWhereItIs(
      double light, double noise, double paint, double shade, String colours) {
    PaintedScene scene = lane(paint).shade(2.0, 3.2, shade).light(light).noise(noise);
    Seen seen = seen(colours.equals("grey") ? scene.grey() : scene);
    assertThat(length(seen.lines())).isGreaterThan(4.5); // of about 6.9 m in the picture
    assertThat(points(seen))
        .allSatisfy(
            point ->
                assertThat(Math.min(Math.abs(point.y() + 0.8), Math.abs(point.y() - 0.9)))
                    .isLessThan(0.02 + 0.02 * point.x()));
  }

  @Test
  void look_lineAcross_isSeenAsWell() {
    Seen seen = seen(new PaintedScene().line(at(2.5, -1.5), at(2.5, 1.5), WIDTH, 1.0));
    assertThat(length(seen.lines())).isGreaterThan(2.2);
    assertThat(points(seen)).allSatisfy(p -> assertThat(p.x()).isCloseTo(2.5, within(0.08)));
  }

  @Test
  void look_gapInThePaint_isBridgedIfShort() {
    PaintedScene scene =
        new PaintedScene()
            .line(at(0.5, -0.5), at(2.0, -0.5), WIDTH, 1.0)
            .line(at(2.4, -0.5), at(4.5, -0.5), WIDTH, 1.0);
    Seen seen = seen(scene);
    assertThat(points(seen)).anySatisfy(p -> assertThat(p.x()).isBetween(2.1, 2.3));
  }

  @Test
  void look_gapInThePaint_staysOpenIfLong() {
    PaintedScene scene =
        new PaintedScene()
            .line(at(0.5, -0.5), at(1.9, -0.5), WIDTH, 1.0)
            .line(at(3.2, -0.5), at(4.8, -0.5), WIDTH, 1.0);
    Seen seen = seen(scene);
    assertThat(seen.lines()).hasSizeGreaterThanOrEqualTo(2);
    assertThat(points(seen)).noneSatisfy(p -> assertThat(p.x()).isBetween(2.1, 3.0));
  }

  @ParameterizedTest
  @CsvSource({"grass", "shadow edge", "strip of sun", "wide glare"})
  void look_whatIsNoPaint_isNoLine(String what) {
    PaintedScene scene = new PaintedScene().noise(4.0);
    switch (what) {
      case "shadow edge" -> scene.shade(1.5, 3.0, 0.35);
      case "strip of sun" -> scene.sunStrip(0.3, WIDTH, 0.45);
      case "wide glare" -> scene.line(at(0.5, 0.2), at(5.0, 0.2), 0.9, 0.8);
      default -> scene.light(0.8);
    }
    Seen seen = seen(scene);
    assertThat(seen.lines()).isEmpty();
    assertThat(seen.discs()).isEmpty();
  }

  @Test
  void look_disc_isAPotholeAndNoLine() {
    Seen seen = seen(new PaintedScene().disc(at(2.4, 0.4), 0.305).noise(3.0));
    assertThat(seen.lines()).isEmpty();
    assertThat(seen.discs()).hasSize(1);
    assertThat(seen.discs().get(0).centre().x()).isCloseTo(2.4, within(0.06));
    assertThat(seen.discs().get(0).centre().y()).isCloseTo(0.4, within(0.04));
    assertThat(seen.discs().get(0).radiusM()).isCloseTo(0.305, within(0.05));
  }

  @Test
  void look_barrel_itsWhiteBandsAreNoLine() {
    Seen seen = seen(new PaintedScene().barrel(at(3.0, -0.5)).noise(3.0));
    assertThat(seen.lines()).isEmpty();
    assertThat(seen.objects()).hasSize(1);
    SeenObject barrel = seen.objects().get(0);
    assertThat(barrel.kind()).isEqualTo(ObjectKind.BARREL);
    assertThat(barrel.foot().x()).isCloseTo(3.0, within(2.0 * barrel.alongM()));
    assertThat(barrel.foot().y()).isCloseTo(-0.5, within(0.08));
  }

  @Test
  void look_lineBehindABarrel_goesOnBesideIt() {
    PaintedScene scene =
        new PaintedScene().line(at(3.6, -2.2), at(3.6, 2.2), WIDTH, 1.0).barrel(at(2.6, 0.0));
    Seen seen = seen(scene);
    assertThat(points(seen)).anySatisfy(p -> assertThat(p.y()).isLessThan(-0.8));
    assertThat(points(seen)).anySatisfy(p -> assertThat(p.y()).isGreaterThan(0.8));
    assertThat(points(seen)).noneSatisfy(p -> assertThat(Math.abs(p.y())).isLessThan(0.2));
  }

  @ParameterizedTest
  @CsvSource({"RED_FLAG, 200, 30, 30", "BLUE_FLAG, 30, 60, 190"})
  void look_flag_isOfItsColourWhereItStands(ObjectKind kind, int red, int green, int blue) {
    PaintedScene scene =
        new PaintedScene()
            .upright(
                at(3.0, 0.5),
                0.16,
                1.0,
                (z, side) -> z < 0.74 ? null : new int[] {red, green, blue})
            .noise(3.0);
    Seen seen = seen(scene);
    assertThat(seen.objects()).hasSize(1);
    SeenObject flag = seen.objects().get(0);
    assertThat(flag.kind()).isEqualTo(kind);
    assertThat(flag.foot().x()).isCloseTo(3.0, within(0.5));
    assertThat(flag.foot().y()).isCloseTo(0.5, within(0.15));
  }

  @Test
  void look_trestle_isASawhorse() {
    PaintedScene scene = new PaintedScene();
    for (int i = 0; i < 5; i++) { // planks of orange and white, seen from ahead
      double right = -0.5 + 0.25 * i;
      scene.upright(
          at(3.0, right),
          0.125,
          1.0,
          (z, side) -> {
            boolean isPlank = z > 0.3 && z < 0.55 || z > 0.75;
            boolean isOrange = (z + 0.5 * side) % 0.3 < 0.14;
            int[] colour = isOrange ? new int[] {235, 112, 40} : new int[] {230, 230, 230};
            return isPlank ? colour : null;
          });
    }
    Seen seen = seen(scene);
    assertThat(seen.lines()).isEmpty();
    assertThat(seen.objects()).extracting(SeenObject::kind).containsOnly(ObjectKind.SAWHORSE);
    assertThat(seen.objects().get(0).foot().x()).isCloseTo(3.0, within(0.5));
  }

  @Test
  void look_sameSightAgain_isTheSameToTheLastBit() {
    PaintedScene scene = lane(0.7).barrel(at(3.0, 0.2)).disc(at(2.0, 0.0), 0.3).noise(5.0);
    CameraFrame frame = scene.picture(VIEW, 9);
    Seen first = sight.look(frame, LENS, MOUNT, 0.01, 0.02);
    sight.look(new PaintedScene().picture(VIEW, 2), LENS, MOUNT, 0.0, 0.0);
    Seen again = sight.look(frame, LENS, MOUNT, 0.01, 0.02);
    assertThat(again.lines()).isEqualTo(first.lines());
    assertThat(again.discs()).isEqualTo(first.discs());
    assertThat(again.objects()).isEqualTo(first.objects());
  }
}
