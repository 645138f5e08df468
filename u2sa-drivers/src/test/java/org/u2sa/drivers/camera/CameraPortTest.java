package org.u2sa.drivers.camera;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.sim.device.SimulatedCamera;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.DeviceContract;

/** Every camera before a scene that is dark on its left half and bright on its right half. */
class CameraPortTest extends DeviceContract<CameraFrame> {
  private static final int WIDTH = 48;
  private static final int HEIGHT = 32;

  @Override
  protected List<Bench<CameraFrame>> benches() {
    MemoryLink link = new MemoryLink();
    byte[] jpeg = Jpegs.darkThenBright(WIDTH, HEIGHT);
    return List.of(
        new LinkedBench<>(
            "MJPEG",
            link,
            new MjpegCamera(link, "/stream"),
            100_000,
            line -> {
              if (new String(link.written(), US_ASCII).startsWith("GET /stream HTTP/1.0\r\n")) {
                line.fromDevice(Jpegs.head());
              }
              line.fromDevice(Jpegs.part(jpeg));
            }),
        new SimulatedBench<>(
            "simulated",
            new SimulatedCamera(
                new SimulatedCamera.Lens(10.0, WIDTH, HEIGHT, 1.0, 0.01),
                new NoiseStreams(1),
                () -> direction -> direction.y() < 0.0 ? 0.1 : 0.9)));
  }

  @Test
  void ahead_obstacleToTheRightOfNorth_isDarkOnTheRightBetweenSkyAndGround() {
    World world =
        World.at(new Geodetic(0.0, 0.0, 0.0))
            .with(
                List.of(
                    new Cylinder()
                        .radius(2.0)
                        .height(20.0)
                        .uid("mast")
                        .referenceFrame(ReferenceFrame.LOCAL_ENU)
                        .x(4.0)
                        .y(10.0)
                        .z(10.0)));
    VehicleTruth truth =
        new VehicleTruth(
            0.0,
            Point.of(0.0, 0.0, 1.0),
            new Attitude(0.0, 0.0, 0.0),
            Point.ORIGIN,
            Point.ORIGIN,
            Point.ORIGIN);
    SimulatedCamera.Scene scene = SimulatedCamera.ahead(world, truth, 100.0);
    double slant = Math.hypot(10.0, 4.0);
    assertThat(scene.brightness(Point.of(10.0 / slant, 4.0 / slant, 0.0))).isLessThan(0.2);
    assertThat(scene.brightness(Point.of(10.0 / slant, -4.0 / slant, 0.0))).isGreaterThan(0.8);
    assertThat(scene.brightness(Point.of(0.8, -0.0, 0.6))).isBetween(0.4, 0.6);
  }

  @Override
  protected void judge(CameraFrame frame) {
    assertThat(frame.width()).isEqualTo(WIDTH);
    assertThat(frame.height()).isEqualTo(HEIGHT);
    assertThat(brightness(frame, 4)).isLessThan(60);
    assertThat(brightness(frame, WIDTH - 4)).isGreaterThan(190);
  }

  private static int brightness(CameraFrame frame, int column) {
    int row = HEIGHT / 2;
    if (frame.format() == CameraFrame.PixelFormat.GREY8) {
      return frame.pixels()[row * WIDTH + column] & 0xFF;
    }
    try {
      return ImageIO.read(new ByteArrayInputStream(frame.pixels())).getRGB(column, row) & 0xFF;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
