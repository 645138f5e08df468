package org.u2sa.scenarios.camera;

import java.nio.file.Path;
import java.util.Optional;
import org.u2sa.device.CameraSensor;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.service.ServiceContext;

/** Camera from a service's configuration, opened in addition to that service. */
final class LiveCamera implements AutoCloseable {
  private static final long POLL_MICROS = Clock.micros(0.02);

  private final Clock clock = new SystemClock();
  private final Camera camera;
  private long lastMicros = Long.MIN_VALUE;

  LiveCamera(XmlConfiguration configuration, Path logs) {
    camera =
        CameraSensor.open(
            ServiceContext.of("camera", configuration).clock(clock).logDirectory(logs).build());
  }

  /**
   * Next image, at least the given time after the last one.
   *
   * @throws BadInputException if none arrives in time; includes the camera's error
   * @throws InterruptedException if the command is terminated
   */
  CameraFrame next(double apartS, double patienceS) throws InterruptedException {
    long end = clock.micros() + Clock.micros(patienceS);
    while (clock.micros() < end) {
      Optional<CameraFrame> frame = camera.read(clock.micros());
      boolean isNew =
          frame.isPresent()
              && (lastMicros == Long.MIN_VALUE
                  || frame.get().measuredAtMicros() >= lastMicros + Clock.micros(apartS));
      if (isNew) {
        lastMicros = frame.get().measuredAtMicros();
        return frame.get();
      }
      Thread.sleep(POLL_MICROS / 1000);
    }
    String trouble = camera.trouble();
    throw new BadInputException(
        String.format("no picture for %.0f s", patienceS)
            + (trouble.isEmpty() ? "" : ": the camera is lost: " + trouble));
  }

  @Override
  public void close() {
    camera.close();
  }
}
