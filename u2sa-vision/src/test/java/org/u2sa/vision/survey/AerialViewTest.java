package org.u2sa.vision.survey;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.vision.ground.CameraMount;

/** From 50 m above a slope that rises by 0.2 towards the east. */
class AerialViewTest {
  private static final Geodetic HERE = new Geodetic(10.0, 50.0, 100.0);
  private static final double RISE = 0.2;
  private static final double UP_M = 50.0;
  private static final int SIDE = 401;
  private static final double FOCAL_PX = 400.0;

  @TempDir private Path folder;

  private AerialView view(boolean onSlope) throws IOException {
    StringBuilder text =
        new StringBuilder(
            "ncols 101\nnrows 101\nxllcenter 9.995\nyllcenter 49.995\ncellsize 0.0001\n");
    for (int i = 0; i < 101 * 101; i++) {
      Geodetic at = new Geodetic(9.995 + i % 101 * 1e-4, 50.0, 100.0);
      text.append(100.0 + RISE * HERE.nedOf(at).y()).append(' ');
    }
    Path map = Files.writeString(folder.resolve("slope.asc"), text);
    CameraFrame frame =
        new CameraFrame(
            0L,
            SIDE,
            SIDE,
            PixelFormat.GREY8,
            new byte[SIDE * SIDE],
            Optional.of(new Intrinsics(FOCAL_PX, FOCAL_PX, SIDE / 2, SIDE / 2)));
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(HERE.longitudeDeg())
            .y(HERE.latitudeDeg())
            .z(100.0 + UP_M)
            .phi(0.0)
            .theta(0.0)
            .psi(0.0);
    CameraMount down =
        new CameraMount(Point.ORIGIN, Rotation.nedFromFrd(0.0, -0.5 * Math.PI, 0.0), 0.0);
    return new AerialView(
        frame, down, state, 100.0, onSlope ? Optional.of(HeightGrid.read(map)) : Optional.empty());
  }

  /** East of the camera, by the exact intersection of a ray with the slope. */
  private static double exactM(double column) {
    double across = (column - SIDE / 2) / FOCAL_PX;
    return across * UP_M / (1.0 + RISE * across);
  }

  @Test
  void ground_slope_isWhereRaysMeetIt() throws IOException {
    AerialView view = view(true);
    for (double column = 0.0; column < SIDE; column += 40.0) {
      Geodetic at = view.ground(column, 200.0).orElseThrow();
      double east = HERE.nedOf(at).y();
      assertThat(east).isCloseTo(exactM(column), within(0.02));
      assertThat(at.altitudeM()).isCloseTo(100.0 + RISE * east, within(0.02));
    }
  }

  @Test
  void resolutionM_slope_isCoarserDownhill() throws IOException {
    AerialView slope = view(true);
    AerialView level = view(false);
    double metres = (exactM(1.0) - exactM(0.0)) * Math.hypot(1.0, RISE);

    assertThat(slope.resolutionM(0.5, 200.0)).isCloseTo(metres, within(0.002));
    assertThat(level.resolutionM(200.0, 200.0)).isCloseTo(UP_M / FOCAL_PX, within(1e-9));
    assertThat(slope.resolutionM(400.0, 200.0)).isLessThan(level.resolutionM(400.0, 200.0));
  }

  @Test
  void footprint_slope_hasTheCoarsestCornerAndItsHeights() throws IOException {
    ImageFootprint seen = view(true).footprint(7).orElseThrow();

    assertThat(seen.points().get(0).z()).isLessThan(100.0);
    assertThat(seen.points().get(1).z()).isGreaterThan(100.0);
    assertThat(seen.resolution())
        .isGreaterThan(view(false).footprint(7).orElseThrow().resolution());
  }
}
