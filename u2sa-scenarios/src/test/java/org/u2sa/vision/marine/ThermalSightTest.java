package org.u2sa.vision.marine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Button;
import org.u2sa.messages.marine.HotTarget;
import org.u2sa.sim.camera.ColourLens;
import org.u2sa.sim.camera.ThermalRenderer;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.vision.lens.LensCalibration;

/** Hot targets among cold ones on rendered thermal pictures. */
class ThermalSightTest {
  private static final ColourLens LENS =
      new ColourLens(9.0, 160, 120, 0.8, 0.0, 0.0, 0.0, 0.0, 0.002, 0.0, 0.0, 0.0, 0.0, 0.0);
  private static final ThermalVariables VARIABLES =
      new ThermalVariables(
          "", "", 268.15, 328.15, 0.8, 295.15, 6.0, 0.5, 0.5, 0.05, 0.8, 0.006, 30.0);

  private static List<ThermalSight.Warm> seen(List<ObjectDescription> objects, long seed) {
    VehicleTruth truth =
        new VehicleTruth(
            0.0,
            Point.of(0.0, 0.0, 0.9),
            new Attitude(0.05, 0.02, Math.PI / 2.0),
            Point.ORIGIN,
            Point.ORIGIN,
            Point.ORIGIN);
    byte[] pixels =
        new ThermalRenderer(LENS, objects, 0.0, 268.15, 328.15, new NoiseStreams(seed))
            .picture(truth);
    CameraFrame frame =
        new CameraFrame(
            0L,
            LENS.width(),
            LENS.height(),
            CameraFrame.PixelFormat.GREY8,
            pixels,
            Optional.of(LENS.intrinsics()));
    return new ThermalSight(VARIABLES)
        .look(frame, LensCalibration.pinhole(160, 120, LENS.intrinsics()));
  }

  @Test
  void look_oneHotAmongColdTargets_isTheOnlyOneAndHonest() {
    for (long seed = 1; seed <= 20; seed++) {
      Random random = new Random(seed);
      double east = 4.0 + 8.0 * random.nextDouble();
      double north = 0.25 * east * (random.nextDouble() - 0.5);
      double excess = 12.0 + 12.0 * random.nextDouble();
      List<ObjectDescription> objects = new ArrayList<>();
      HotTarget hot = new HotTarget().length(0.05).width(0.5).height(0.5).psi(Math.PI);
      objects.add(RenderedBuoys.at(hot.excessTemperature(excess), east, north, 0.8));
      HotTarget cold = new HotTarget().length(0.05).width(0.5).height(0.5).psi(Math.PI);
      objects.add(RenderedBuoys.at(cold.excessTemperature(0.0), east, north + 1.0, 0.8));
      objects.add(RenderedBuoys.at(new Buoy().radius(0.25), east, north - 1.0, 0.0));
      objects.add(RenderedBuoys.at(new Button().length(0.1).width(0.3).height(0.3), 9.0, 0.0, 2.0));

      List<ThermalSight.Warm> seen = seen(objects, seed);

      assertThat(seen).as("seed %d", seed).hasSize(1);
      SeenThing thing = seen.get(0).thing();
      double range = Math.hypot(Math.hypot(east, north), 0.1);
      assertThat(thing.rangeM())
          .as("seed %d", seed)
          .isEqualTo(range, within(3.0 * thing.rangeSigmaM()));
      assertThat(seen.get(0).excessK()).isEqualTo(excess, within(1.5));
    }
  }

  @Test
  void look_nothingHot_seesNothing() {
    assertThat(seen(List.of(RenderedBuoys.at(new Buoy().radius(0.5), 6.0, 0.0, 0.0)), 4L))
        .isEmpty();
  }
}
