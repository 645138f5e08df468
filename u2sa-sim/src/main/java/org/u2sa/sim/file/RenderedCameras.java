package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.Light;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.camera.ThermalRenderer;
import org.u2sa.sim.camera.WaterLook;
import org.u2sa.sim.camera.WaterScenery;
import org.u2sa.sim.camera.WaterType;
import org.u2sa.sim.device.SimulatedColourCamera;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.world.Sunlight;
import org.u2sa.sim.world.World;

/** Cameras of vehicle files with rendered images of land or water, and thermal cameras. */
final class RenderedCameras {
  private static final int MAX_PIXELS = 4_000;
  private static final int MAX_PARTICLES = 10_000;
  private static final double EXPOSURE_S = 0.004;
  private static final double BLUR = 0.6;

  /** Content of a camera's images. */
  enum Picture {
    COLOUR,
    THERMAL
  }

  private RenderedCameras() {}

  static SensorKinds.Reader read(FileElement file, Map<String, Double> mounted, Mount mount) {
    ColourLens lens =
        new ColourLens(
            file.number("rate", "Hz", 0.1, 120.0),
            file.count("width", 2, MAX_PIXELS),
            file.count("height", 2, MAX_PIXELS),
            file.number("view", "rad", 0.01, 3.0),
            0.0,
            0.0,
            EXPOSURE_S,
            0.0,
            file.number("sigma", "1", 0.0, 1.0),
            BLUR,
            0.0,
            0.0,
            0.0,
            0.0);
    if (file.choice("picture", Picture.class) == Picture.THERMAL) {
      double coldest = file.number("coldest", "K", 100.0, 2_000.0);
      double hottest = file.number("hottest", "K", coldest + 1.0, 3_000.0);
      return new SensorKinds.Reader(
          mounted,
          vehicle ->
              new SimulatedColourCamera(
                  lens,
                  new ThermalRenderer(
                      lens,
                      objects(vehicle.world()),
                      vehicle.world().water().map(water -> water.surfaceM()).orElse(0.0),
                      coldest,
                      hottest,
                      vehicle.streams()),
                  vehicle.at(mount)));
    }
    WaterType type =
        file.has("waterType") ? file.choice("waterType", WaterType.class) : WaterType.C3;
    double scattering = file.number("scattering", "1", 0.0, 10.0, 0.4);
    int particles = file.has("particles") ? file.count("particles", 0, MAX_PARTICLES) : 0;
    return new SensorKinds.Reader(
        mounted,
        vehicle -> {
          World world = vehicle.world();
          Light light = world.light().map(RenderedCameras::light).orElseGet(Light::clear);
          long seed = vehicle.streams().of("scenery").nextLong();
          if (world.water().isEmpty()) {
            return new SimulatedColourCamera(
                lens,
                new Scenery(objects(world), light, seed),
                vehicle.streams(),
                vehicle.at(mount));
          }
          double surface = world.water().get().surfaceM();
          double depth = Math.max(0.5, surface - world.terrain().heightM(0.0, 0.0));
          WaterLook look =
              new WaterLook(
                  surface,
                  Math.min(depth, 12_000.0),
                  type,
                  scattering,
                  Math.min(40.0, world.wind().speedMps()),
                  particles);
          return new SimulatedColourCamera(
              lens,
              new WaterScenery(objects(world), look, light, seed),
              vehicle.streams(),
              vehicle.at(mount));
        });
  }

  private static Light light(Sunlight sun) {
    return new Light(
        sun.azimuthRad(),
        Math.max(0.05, Math.min(1.5, sun.elevationRad())),
        sun.share(),
        Math.max(0.01, 1.0 - sun.share()),
        0.0,
        0.1,
        0.0);
  }

  /** The world's obstacles in LOCAL_ENU. */
  private static List<ObjectDescription> objects(World world) {
    Geodetic origin = world.plane().origin();
    StateInformation onEarth =
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(origin.longitudeDeg())
            .y(origin.latitudeDeg())
            .z(origin.altitudeM())
            .psi(0.0);
    StateInformation onPlane =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(0.0).y(0.0).psi(0.0);
    List<ObjectDescription> local = new ArrayList<>();
    for (ObjectDescription object : world.obstacles()) {
      ObjectDescription placed =
          object.referenceFrame().isEarth()
              ? object
                  .in(ReferenceFrame.GLOBAL, null)
                  .in(ReferenceFrame.BODY_FRD, onEarth)
                  .in(ReferenceFrame.LOCAL_NED, onPlane)
              : object;
      local.add(placed.in(ReferenceFrame.LOCAL_ENU, null));
    }
    return local;
  }
}
