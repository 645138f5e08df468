package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.device.GpsSensor;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.service.ServiceContext;

class ServiceMakerTest {
  /** A simulation, whose devices must not be made twice. */
  private static final class Simulation implements ServiceContext.DeviceSource {
    @Override
    public <D> Optional<D> device(
        Class<D> port, String service, XmlConfiguration variables, Clock clock) {
      throw new IllegalStateException("a trial takes no device");
    }
  }

  private static void tryGps(LaunchOptions options) {
    new ServiceMaker(
            "test",
            options.clock(new LockstepClock()),
            MessageTypes.discovered(),
            new LocalBus("test"))
        .tryOut(GpsSensor.class.getName(), XmlConfiguration.inMemory("GpsSensor", Map.of()));
  }

  @Test
  void tryOut_serviceWhoseDeviceIsSimulated_endsBeforeTheDevice() {
    assertThatCode(() -> tryGps(new LaunchOptions().devices(new Simulation())))
        .doesNotThrowAnyException();
  }

  @Test
  void tryOut_serviceWhoseDriverIsMissing_saysSo() {
    assertThatThrownBy(() -> tryGps(new LaunchOptions()))
        .hasMessageContaining("no driver on the class path");
  }
}
