package org.u2sa.testkit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.device.port.Device;

/**
 * What every implementation of a port keeps, whatever is behind it. A port's test extends this with
 * a bench for each implementation.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
public abstract class DeviceContract<R extends Device.Reading> {
  private static final long STEP_MICROS = 10_000;

  /** One implementation and its far side. */
  public abstract static class Bench<R extends Device.Reading> {
    private final String name;
    private long nowMicros = 1_000_000;

    /** With the implementation's name in reports. */
    protected Bench(String name) {
      this.name = name;
    }

    /** The device; the same at each call. */
    public abstract Device<R> device();

    /** Lets the far side measure and speak; before each read, 100 times a second. */
    public abstract void live(long nowMicros);

    /** Takes the device away, or brings it back. */
    public abstract void plug(boolean in);

    /** Time of the run's clock [µs]. */
    public final long nowMicros() {
      return nowMicros;
    }

    private Optional<R> step() {
      nowMicros += STEP_MICROS;
      live(nowMicros);
      return device().read(nowMicros);
    }

    private Set<R> run(double seconds) {
      Set<R> readings = new LinkedHashSet<>();
      for (long end = nowMicros + Math.round(seconds * 1e6); nowMicros < end; ) {
        step().ifPresent(readings::add);
      }
      return readings;
    }

    @Override
    public String toString() {
      return name;
    }
  }

  /** A new bench for each implementation. */
  protected abstract List<Bench<R>> benches();

  /** Asserts that a reading is what the far side measured, in the port's units and directions. */
  protected abstract void judge(R reading);

  @ParameterizedTest
  @MethodSource("benches")
  final void read_deviceThatMeasures_isWhatWasMeasuredInTheOrderOfTime(Bench<R> bench) {
    Set<R> readings = bench.run(3.0);
    assertThat(readings).hasSizeGreaterThan(1).allSatisfy(this::judge);
    assertThat(readings.stream().map(Device.Reading::measuredAtMicros).toList())
        .isSorted()
        .doesNotHaveDuplicates()
        .allSatisfy(at -> assertThat(at).isBetween(1_000_000L, bench.nowMicros()));
    assertThat(bench.device().isConnected()).isTrue();
    assertThat(bench.device().connections()).isEqualTo(1);
    assertThat(bench.device().trouble()).isEmpty();
    assertThat(bench.device().malformed()).isZero();
  }

  @ParameterizedTest
  @MethodSource("benches")
  final void read_nothingNew_isTheSameReading(Bench<R> bench) {
    bench.run(3.0);
    R first = bench.device().read(bench.nowMicros()).orElseThrow();
    assertThat(bench.device().read(bench.nowMicros())).hasValue(first);
  }

  @ParameterizedTest
  @MethodSource("benches")
  final void read_unpluggedDevice_saysSoAndReturnsNothingNew(Bench<R> bench) {
    bench.run(3.0);
    R last = bench.device().read(bench.nowMicros()).orElseThrow();
    bench.plug(false);
    assertThat(bench.run(1.0)).isSubsetOf(List.of(last));
    assertThat(bench.device().isConnected()).isFalse();
    assertThat(bench.device().trouble()).isNotEmpty();
  }

  @ParameterizedTest
  @MethodSource("benches")
  final void read_pluggedInAgain_goesOnWithinThreeSeconds(Bench<R> bench) {
    bench.run(3.0);
    bench.plug(false);
    bench.run(1.0);
    bench.plug(true);
    long pluggedMicros = bench.nowMicros();
    Set<R> readings = bench.run(3.0);
    assertThat(readings)
        .anySatisfy(reading -> assertThat(reading.measuredAtMicros()).isGreaterThan(pluggedMicros))
        .allSatisfy(this::judge);
    assertThat(bench.device().connections()).isEqualTo(2);
    assertThat(bench.device().trouble()).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("benches")
  final void close_withOrWithoutDevice_doesNotThrow(Bench<R> bench) {
    bench.run(0.1);
    bench.plug(false);
    bench.device().close();
  }
}
