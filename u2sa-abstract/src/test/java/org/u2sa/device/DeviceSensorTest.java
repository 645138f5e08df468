package org.u2sa.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.device.port.Pressure;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.ConfigurationException;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

/** What all sensors with a device have in common. */
class DeviceSensorTest {
  private static final List<Channel<?>> STATE = List.of(Channels.SENSED_STATE);
  private static final List<Channel<?>> OBJECTS = List.of(Channels.SENSED_OBJECTS);
  private static final List<Channel<?>> SCANS = List.of(Channels.SENSED_OBJECTS, Channels.SCANS);

  @AutoClose private final ServiceKit kit = new ServiceKit();

  /** A kind of sensor with a device that says nothing. */
  record Mute(
      String device,
      double silentAfterS,
      List<Channel<?>> published,
      Function<ServiceContext, DeviceSensor<?>> sensor) {
    @Override
    public String toString() {
      return device;
    }
  }

  static List<Mute> kinds() {
    return List.of(
        new Mute("pitot tube", 1.0, STATE, c -> new AirspeedSensor(c, now -> Optional.empty())),
        new Mute("barometer", 1.0, STATE, c -> new BarometerSensor(c, now -> Optional.empty())),
        new Mute("compass", 1.5, STATE, c -> new CompassSensor(c, now -> Optional.empty())),
        new Mute("depth gauge", 1.0, STATE, c -> new DepthSensor(c, now -> Optional.empty())),
        new Mute("GPS receiver", 2.5, STATE, c -> new GpsSensor(c, now -> Optional.empty())),
        new Mute("IMU", 0.5, STATE, c -> new ImuSensor(c, now -> Optional.empty())),
        new Mute("laser", 1.0, SCANS, c -> new LidarSensor(c, now -> Optional.empty())),
        new Mute("range finder", 0.5, OBJECTS, c -> new RangeSensor(c, now -> Optional.empty())),
        new Mute("sonar", 4.0, SCANS, c -> new SonarSensor(c, now -> Optional.empty())),
        new Mute(
            "traffic receiver", 10, OBJECTS, c -> new TrafficSensor(c, now -> Optional.empty())),
        new Mute("velocity log", 2.0, STATE, c -> new WaterSpeedSensor(c, now -> Optional.empty())),
        new Mute(
            "wheel encoder", 0.5, STATE, c -> new WheelEncoderSensor(c, now -> Optional.empty())));
  }

  @ParameterizedTest
  @MethodSource("kinds")
  void step_mute_isReportedAfterTheTimeoutOfItsKind(Mute kind) {
    DeviceSensor<?> service = kit.start(kind.sensor);
    String name = service.getClass().getSimpleName();
    assertThat(service.getServiceName()).isEqualTo(name);
    assertThat(service.publishedChannels()).isEqualTo(kind.published);
    kit.advance(kind.silentAfterS - 0.1);
    assertThat(kit.log(name)).noneMatch(line -> line.contains("WARN"));
    kit.advance(0.2);
    String silent =
        ("the " + kind.device + " has sent no valid data for more than ")
            + (kind.silentAfterS + " s");
    assertThat(kit.log(name)).anyMatch(line -> line.contains("WARN") && line.contains(silent));
  }

  @Test
  void step_timeoutConfigured_countsInsteadOfTheKinds() {
    kit.with("TIMEOUT", 5.0).start(context -> new RangeSensor(context, now -> Optional.empty()));
    kit.advance(4.0);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError)).isEmpty();
    kit.advance(2.0);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValue("the range finder has sent no valid data for more than 5.0 s");
  }

  @Test
  void step_reading_isPublishedOnceWithTheTimeOfItsMeasurement() {
    Optional<Pressure> pressure = Optional.of(new Pressure(7, 101_325.0, OptionalDouble.empty()));
    kit.start(context -> new DepthSensor(context, now -> pressure));
    kit.advance(1.0);
    assertThat(kit.published(Channels.SENSED_STATE))
        .extracting(StateInformation::timestamp)
        .containsExactly(OptionalLong.of(7));
  }

  /** Counts its closings. */
  public static final class Echo extends DeviceProvider<RangeFinder> implements RangeFinder {
    private static final AtomicInteger CLOSINGS = new AtomicInteger();

    /** For {@link java.util.ServiceLoader}. */
    public Echo() {
      super(RangeFinder.class, "ECHO");
    }

    @Override
    protected RangeFinder open(String name, ServiceContext context) {
      return this;
    }

    @Override
    public Optional<Distance> read(long nowMicros) {
      return Optional.empty();
    }

    @Override
    public void close() {
      CLOSINGS.incrementAndGet();
    }
  }

  @Test
  void construct_variableRefusedAfterTheDeviceWasOpened_deviceIsClosed(@TempDir Path folder)
      throws Exception {
    kit.with("MODEL", "ECHO").with("MOUNTED X", 1e9);
    RegisteredProviders providers = new RegisteredProviders(folder, Echo.class);
    try {
      ServiceContext context = kit.context();
      int before = Echo.CLOSINGS.get();
      assertThatThrownBy(() -> new RangeSensor(context)).isInstanceOf(ConfigurationException.class);
      context.abandon();
      assertThat(Echo.CLOSINGS.get() - before).isEqualTo(1);
    } finally {
      providers.close();
    }
  }
}
