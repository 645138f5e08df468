package org.u2sa.sim.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * What is rendered lies where the pinhole camera has it. The vehicle stands at the origin, north.
 */
class RendererTest {
  private static final int WIDTH = 160;
  private static final int HEIGHT = 120;

  /** 90° wide, 1 m up, 20° down, still and without noise or blur. */
  private static final ColourLens LENS =
      new ColourLens(
          10.0, WIDTH, HEIGHT, Math.PI / 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.349);

  private static VehicleTruth truth(double yawRate) {
    return new VehicleTruth(
        0.0,
        Point.ORIGIN,
        new Attitude(0.0, 0.0, 0.0),
        Point.ORIGIN,
        Point.of(0.0, 0.0, yawRate),
        Point.ORIGIN);
  }

  private static byte[] picture(
      ColourLens lens, Light light, double yawRate, ObjectDescription... o) {
    Scenery scenery = new Scenery(List.of(o), light, 7L);
    return new Renderer(lens, scenery, new NoiseStreams(7L)).picture(truth(yawRate));
  }

  private static byte[] picture(ObjectDescription... objects) {
    return picture(LENS, Light.even(), 0.0, objects);
  }

  private static int[] pixel(byte[] picture, double east, double north, double up) {
    double sin = Math.sin(LENS.downRad());
    double cos = Math.cos(LENS.downRad());
    double below = 1.0 - up;
    double ahead = north * cos + below * sin;
    double down = below * cos - north * sin;
    double focal = LENS.intrinsics().focalX();
    int column = (int) Math.round(focal * east / ahead + LENS.intrinsics().centreX());
    int row = (int) Math.round(focal * down / ahead + LENS.intrinsics().centreY());
    int at = 3 * (row * WIDTH + column);
    return new int[] {picture[at] & 0xFF, picture[at + 1] & 0xFF, picture[at + 2] & 0xFF};
  }

  private static <O extends ObjectDescription> O placed(O object, String type, double x, double y) {
    object.objectType(type).uid(type).referenceFrame(ReferenceFrame.LOCAL_ENU).x(x).y(y).z(0.0);
    return object;
  }

  private static PolyLine line(double east) {
    PolyLine line = placed(new PolyLine(), Scenery.LINE, east, 0.0);
    line.width(0.12);
    return line.points(List.of(Point.of(east, 0.0, 0.0), Point.of(east, 10.0, 0.0)));
  }

  @Test
  void picture_paintedLine_isBrightWhereItLiesAndGrassBesideIt() {
    byte[] picture = picture(line(1.0));
    for (double north = 1.5; north < 4.0; north += 0.25) {
      assertThat(pixel(picture, 1.0, north, 0.0)[2]).isGreaterThan(150);
      assertThat(pixel(picture, 0.6, north, 0.0)[2]).isLessThan(120);
      assertThat(pixel(picture, -1.0, north, 0.0)[2]).isLessThan(120);
    }
  }

  /** 15 % from 2 m ahead on: 2 m farther the line is 0.3 m up, where the pinhole has it. */
  @Test
  void picture_lineOverARamp_isSeenWhereItIsUpOnTheBoards() {
    PolyLine ramp = placed(new PolyLine(), Scenery.RAMP, 0.0, 2.0);
    ramp.width(4.0)
        .points(
            List.of(Point.of(0.0, 2.0, 0.0), Point.of(0.0, 4.5, 0.375), Point.of(0.0, 7.0, 0.0)));
    byte[] picture = picture(ramp, line(1.0));
    for (double north = 2.4; north < 4.2; north += 0.3) {
      double up = 0.15 * (north - 2.0);
      int boards = pixel(picture, 0.5, north, up)[2];
      assertThat(pixel(picture, 1.0, north, up)[2])
          .as("%s m ahead", north)
          .isGreaterThan(boards + 40);
    }
    int grey = pixel(picture, 0.5, 3.7, 0.255)[2];
    assertThat(pixel(picture, 1.0, 4.0, 0.0)[2]).as("as if level").isLessThan(grey + 30);
    int[] wood = pixel(picture, 0.0, 3.5, 0.225);
    assertThat(wood[0]).as("redder than grass").isGreaterThan(wood[1]);
  }

  @Test
  void picture_barrel_isOrangeAndHidesWhatIsBehind() {
    Cylinder barrel = placed(new Cylinder(), Scenery.BARREL, 0.0, 3.0);
    barrel.radius(0.3).height(1.0);
    byte[] picture = picture(barrel);
    int[] band = pixel(picture, 0.0, 2.7, 0.2);
    assertThat(band[0]).isGreaterThan(2 * band[2]);
    assertThat(band[0]).isGreaterThan(band[1] + 40);
    int[] beside = pixel(picture, 0.7, 2.7, 0.2);
    assertThat(beside[1]).isGreaterThan(beside[0] - 15);
  }

  @Test
  void picture_redAndBlueFlags_haveTheirColours() {
    Cylinder red = placed(new Cylinder(), Scenery.RED_FLAG, 0.0, 2.5);
    red.radius(0.03).height(1.0);
    byte[] picture = picture(red);
    long reddish = count(picture, (r, g, b) -> r > 2 * g && r > 2 * b && r > 60);
    red.objectType(Scenery.BLUE_FLAG);
    byte[] other = picture(red);
    long bluish = count(other, (r, g, b) -> b > 2 * r && b > 1.5 * g && b > 60);
    assertThat(reddish).isGreaterThan(10);
    assertThat(bluish).isGreaterThan(10);
  }

  private interface Is {
    boolean so(int red, int green, int blue);
  }

  private static long count(byte[] picture, Is is) {
    long count = 0;
    for (int i = 0; i < picture.length; i += 3) {
      boolean so = is.so(picture[i] & 0xFF, picture[i + 1] & 0xFF, picture[i + 2] & 0xFF);
      count += so ? 1 : 0;
    }
    return count;
  }

  @Test
  void picture_pothole_isWhite() {
    Circle hole = placed(new Circle(), Scenery.POTHOLE, 0.0, 2.5);
    hole.radius(0.3);
    assertThat(pixel(picture(hole), 0.0, 2.5, 0.0)[2]).isGreaterThan(150);
  }

  @Test
  void picture_shadowOfABarrel_liesAwayFromTheSun() {
    Cylinder barrel = placed(new Cylinder(), Scenery.BARREL, 0.0, 4.0);
    barrel.radius(0.3).height(1.0);
    Light east = new Light(Math.PI / 2.0, 0.6, 0.8, 0.2, 0.0, 0.0, 0.0);
    byte[] picture = picture(LENS, east, 0.0, barrel);
    assertThat(pixel(picture, -0.9, 4.0, 0.0)[1]).isLessThan(pixel(picture, 0.9, 4.0, 0.0)[1] - 20);
  }

  @Test
  void picture_ofTheSameSeed_isTheSameToTheByte() {
    ColourLens noisy = ColourLens.mast();
    Light light = Light.clear();
    assertThat(picture(noisy, light, 0.3, line(1.0)))
        .isEqualTo(picture(noisy, light, 0.3, line(1.0)));
  }

  @Test
  void picture_rollingShutterInATurn_bendsALine() {
    ColourLens rolling =
        new ColourLens(
            10.0, WIDTH, HEIGHT, Math.PI / 2.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 1.0, 0.349);
    byte[] still = picture(rolling, Light.even(), 0.0, line(0.0));
    byte[] turning = picture(rolling, Light.even(), 1.0, line(0.0));
    // A row later by t sees the ground at d ahead and z from the lens moved by f t d / z: in row 60
    // 80 * 0.050 * 2.75 / 2.92, in row 110 80 * 0.092 * 0.78 / 1.07.
    assertThat(middle(turning, 60) - middle(still, 60)).isBetween(-4.8, -2.8);
    assertThat(middle(turning, 110) - middle(still, 110)).isBetween(-6.4, -4.4);
  }

  /** Mean column of what is bright in a row. */
  private static double middle(byte[] picture, int row) {
    double sum = 0.0;
    int count = 0;
    for (int column = 0; column < WIDTH; column++) {
      if ((picture[3 * (row * WIDTH + column) + 2] & 0xFF) > 150) {
        sum += column;
        count++;
      }
    }
    assertThat(count).isPositive();
    return sum / count;
  }

  @Test
  void picture_solidsAllAround_isThatOfTracingThemInEveryPixel() {
    ColourLens mast =
        new ColourLens(
            10.0, WIDTH, HEIGHT, 1.75, 0.0, 0.0, 0.004, 0.025, 0.0, 0.6, 0.1, 0.0, 1.1, 0.38);
    double tiny = 1e-18; // distorts nothing, but then there are no bounding boxes
    ColourLens everywhere =
        new ColourLens(
            10.0, WIDTH, HEIGHT, 1.75, tiny, 0.0, 0.004, 0.025, 0.0, 0.6, 0.1, 0.0, 1.1, 0.38);
    List<ObjectDescription> around = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      double away = 0.5 + 0.3 * i;
      double x = away * Math.sin(2.5 * i);
      double y = away * Math.cos(2.5 * i);
      around.add(
          i % 3 == 0
              ? placed(new Cylinder(), Scenery.RED_FLAG, x, y).radius(0.01).height(0.6)
              : placed(new Cylinder(), Scenery.BARREL, x, y).radius(0.3).height(1.0));
    }
    Scenery scenery = new Scenery(around, Light.clear(), 7L);
    Renderer boxed = new Renderer(mast, scenery, new NoiseStreams(7L));
    Renderer unboxed = new Renderer(everywhere, scenery, new NoiseStreams(7L));
    for (double heading = 0.0; heading < 6.3; heading += 0.3) {
      VehicleTruth truth =
          new VehicleTruth(
              0.0,
              Point.ORIGIN,
              new Attitude(0.05, -0.05, heading),
              Point.of(1.0, 1.0, 0.0),
              Point.of(0.1, 0.1, 1.0),
              Point.ORIGIN);
      assertThat(boxed.picture(truth)).as("heading " + heading).isEqualTo(unboxed.picture(truth));
    }
  }
}
