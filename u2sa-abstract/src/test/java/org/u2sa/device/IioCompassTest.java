package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.port.Device;
import org.u2sa.device.port.Heading;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.testkit.DeviceContract;
import org.u2sa.testkit.ServiceKit;

class IioCompassTest extends DeviceContract<Heading> {
  @TempDir static Path folder;

  private Path file() {
    return folder.resolve("in_rot_from_north_magnetic_raw");
  }

  @Test
  @SuppressWarnings("try") // the registration is there to be closed, not called
  void configuration_namesIt_headingsArePublished(@TempDir Path list) throws IOException {
    try (ServiceKit kit = new ServiceKit();
        RegisteredProviders registered = new RegisteredProviders(list, IioCompass.Provider.class)) {
      kit.with("COMPASS", "IIO").with("CONNECTION", file().toString()).with("NORTH", "FIXED");
      Files.writeString(file(), "90.0\n");
      kit.start(CompassSensor::new);
      kit.advance(0.1);
      assertThat(kit.latest(Channels.SENSED_STATE).orElseThrow().psi().orElseThrow())
          .isCloseTo(Math.PI / 2.0, within(1e-9));

      Files.delete(file());
      kit.advance(1.0);
      assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElseThrow())
          .startsWith("the compass is lost: java.nio.file.NoSuchFileException");
    }
  }

  @Override
  protected List<Bench<Heading>> benches() {
    IioCompass compass = new IioCompass(file());
    return List.of(
        new Bench<Heading>("file") {
          private boolean isIn = true;

          @Override
          public Device<Heading> device() {
            return compass;
          }

          @Override
          public void live(long nowMicros) {
            try {
              if (isIn) {
                Files.writeString(file(), "90.0\n");
              } else {
                Files.deleteIfExists(file());
              }
            } catch (IOException e) {
              throw new UncheckedIOException(e);
            }
          }

          @Override
          public void plug(boolean in) {
            isIn = in;
          }
        });
  }

  @Override
  protected void judge(Heading heading) {
    assertThat(Math.toDegrees(heading.headingRad())).isCloseTo(90.0, within(1e-9));
  }
}
