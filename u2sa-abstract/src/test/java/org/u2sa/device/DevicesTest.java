package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.device.port.Imu;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

/** How a configuration chooses among the devices of a port. */
class DevicesTest {
  private final ServiceKit kit = new ServiceKit();

  @TempDir private Path folder;
  private RegisteredProviders providers;

  @BeforeEach
  void register() throws IOException {
    providers = new RegisteredProviders(folder, IioCompass.Provider.class, One.class, Other.class);
  }

  @AfterEach
  void end() throws IOException {
    kit.close();
    providers.close();
  }

  /** Two that offer the same name. */
  public static class One extends DeviceProvider<RangeFinder> {
    private record Variables(@Variable(ifAbsent = 0.5) @Description("Gain.") double gain) {}

    /** For {@link java.util.ServiceLoader}. */
    public One() {
      super(RangeFinder.class, "TWICE");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(Variables.class);
    }

    @Override
    protected RangeFinder open(String name, ServiceContext context) {
      return nowMicros -> Optional.empty();
    }
  }

  /** The other one. */
  public static final class Other extends One {}

  @Test
  void open_nameThatNobodyOffers_isRefusedWithThoseThatThereAre() {
    kit.with("COMPASS", "FLUXGATE");
    assertThatThrownBy(() -> new CompassSensor(kit.context()))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("\"FLUXGATE\" is not one of \"IIO\"");
  }

  @Test
  void open_usualDeviceWithoutItsDriver_saysSo() {
    assertThatThrownBy(() -> new ImuSensor(kit.context()))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "variable \"IMU\": no driver on the class path offers Imu \"VECTORNAV\"; there are []");
  }

  @Test
  void open_twoOfOneName_areRefused() {
    assertThatThrownBy(() -> new RangeSensor(kit.context()))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "RangeFinder \"TWICE\" is offered by both "
                + ("org.u2sa.device.DevicesTest$One and org.u2sa.device.DevicesTest$Other"));
  }

  @Test
  void open_madeByTheHost_isUsedWhateverTheConfigurationNames() {
    Imu made = nowMicros -> Optional.empty();
    kit.with("IMU", "VECTORNAV");
    assertThat(kit.start(context -> new ImuSensor(context, made)).isRunning()).isTrue();
  }
}
