package org.u2sa.vision.marine;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.WaterLook;
import org.u2sa.sim.camera.WaterRenderer;
import org.u2sa.sim.camera.WaterScenery;
import org.u2sa.sim.camera.WaterType;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.lens.LensCalibration;

/** Pictures of six random buoys each, and the score of their detection. */
final class RenderedBuoys {
  static final int WIDTH = 640;
  static final int HEIGHT = 480;
  private static final double TILT_ERROR = 0.01;

  private final boolean underWater;
  private final Colour[] colours;
  private final double radiusM;
  int shown;
  int found;
  int falseAlarms;
  int wrongColours;
  int rangesWithin3Sigma;
  int bearingsWithin3Sigma;

  RenderedBuoys(boolean underWater, Colour... colours) {
    this.underWater = underWater;
    this.colours = colours;
    radiusM = underWater ? 0.15 : 0.25;
  }

  static ColourLens lens() {
    return new ColourLens(
        10.0, WIDTH, HEIGHT, 1.4, 0.0, 0.0, 0.004, 0.0, 0.01, 0.6, 0.0, 0.0, 0.0, 0.0);
  }

  static <T extends ObjectDescription> T at(T object, double east, double north, double up) {
    object.uid("1").referenceFrame(ReferenceFrame.LOCAL_ENU).x(east).y(north).z(up);
    return object;
  }

  static CameraFrame picture(
      List<ObjectDescription> objects, WaterLook look, Light light, VehicleTruth truth, long seed) {
    WaterRenderer renderer =
        new WaterRenderer(
            lens(), new WaterScenery(objects, look, light, seed), new NoiseStreams(seed));
    return new CameraFrame(
        0L,
        WIDTH,
        HEIGHT,
        CameraFrame.PixelFormat.RGB24,
        renderer.picture(truth),
        Optional.of(lens().intrinsics()));
  }

  static MarineVariables variables(boolean underWater, double buoyRadius) {
    return new MarineVariables(
        "Buoy,Pole,Hoop,Button,Dock,Bin,PathMarker",
        "",
        "",
        "",
        1.4,
        underWater,
        0.275,
        0.084,
        0.066,
        underWater ? 0.0 : 0.9,
        0.015,
        buoyRadius,
        1.5,
        0.4,
        0.4,
        3.0,
        0.42,
        0.28,
        1.2,
        0.15,
        0.03,
        1.5,
        0.006,
        25.0);
  }

  static MarineSight sight(MarineVariables variables) {
    return new MarineSight(
        variables, new CameraMount(Point.ORIGIN, Rotation.nedFromFrd(0.0, 0.0, 0.0), 0.0));
  }

  void score(long seed) {
    Random random = new Random(seed);
    List<ObjectDescription> objects = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      double range =
          underWater ? 1.5 + 6.0 * random.nextDouble() : 4.0 + 12.0 * random.nextDouble();
      double way = -0.55 + 0.2 * i + 0.06 * random.nextDouble();
      double up = underWater ? -2.5 + random.nextDouble() : 0.05;
      Buoy buoy = new Buoy().radius(radiusM).colour(colours[(int) ((i + seed) % colours.length)]);
      objects.add(at(buoy, range * Math.cos(way), range * Math.sin(way), up));
    }
    Light light = Light.random(random);
    double wind = 1.0 + 6.0 * random.nextDouble();
    WaterLook look =
        underWater ? WaterLook.pool() : new WaterLook(0.0, 6.0, WaterType.C3, 0.4, wind, 0);
    Attitude attitude =
        new Attitude(
            0.16 * (random.nextDouble() - 0.5),
            -0.05 + 0.06 * (random.nextDouble() - 0.5),
            Math.PI / 2.0);
    Point place = Point.of(0.0, 0.0, underWater ? -2.0 : 0.9);
    VehicleTruth truth =
        new VehicleTruth(
            5.0 * random.nextDouble(), place, attitude, Point.ORIGIN, Point.ORIGIN, Point.ORIGIN);
    CameraFrame frame = picture(objects, look, light, truth, seed);
    Rotation level =
        Rotation.nedFromFrd(
            attitude.phi() + TILT_ERROR * random.nextGaussian(),
            attitude.theta() + TILT_ERROR * random.nextGaussian(),
            0.0);
    List<SeenThing> seen =
        new ArrayList<>(
            sight(variables(underWater, radiusM))
                .look(
                    frame,
                    LensCalibration.pinhole(WIDTH, HEIGHT, lens().intrinsics()),
                    level,
                    EnumSet.of(MarineKind.BUOY)));
    for (ObjectDescription object : objects) {
      Point ned = Point.of(object.y(), object.x(), place.z() - object.z());
      compare((Buoy) object, attitude.nedFromFrd().transposed().times(ned), seen);
    }
    falseAlarms += seen.size();
  }

  private void compare(Buoy buoy, Point frd, List<SeenThing> seen) {
    double range = frd.distance();
    Point way = frd.times(1.0 / range);
    if (Math.abs(frd.y()) > 0.8 * frd.x() || Math.abs(frd.z()) > 0.58 * frd.x()) {
      return; // not in the picture
    }
    shown++;
    Optional<SeenThing> match =
        seen.stream()
            .filter(each -> each.way().distanceTo(way) < Math.max(0.02, 0.8 * radiusM / range))
            .findFirst();
    if (match.isPresent()) {
      SeenThing thing = match.get();
      seen.remove(thing);
      found++;
      wrongColours += thing.colour().equals(buoy.colour()) ? 0 : 1;
      rangesWithin3Sigma += Math.abs(thing.rangeM() - range) <= 3.0 * thing.rangeSigmaM() ? 1 : 0;
      double sigma = Math.hypot(0.006, 1.5 / lens().intrinsics().focalX());
      bearingsWithin3Sigma += thing.way().distanceTo(way) <= 3.0 * sigma ? 1 : 0;
    }
  }

  @Override
  public String toString() {
    return String.format(
        "%d of %d found, %d false, %d wrong colours, %d ranges and %d bearings within 3 sigma",
        found, shown, falseAlarms, wrongColours, rangesWithin3Sigma, bearingsWithin3Sigma);
  }
}
