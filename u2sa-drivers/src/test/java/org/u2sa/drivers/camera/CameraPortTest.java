package org.u2sa.drivers.camera;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import javax.imageio.ImageIO;
import org.u2sa.device.CameraFrame;
import org.u2sa.drivers.link.LinkedBench;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.link.SimulatedBench;
import org.u2sa.sim.device.SimulatedCamera;
import org.u2sa.sim.sensor.NoiseStreams;
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
