import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import java.util.Random;
import org.u2sa.estimation.fusion.ErrorStateFilter;
import org.u2sa.estimation.fusion.FilterTuning;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.fusion.MotionDomain;

/**
 * Processor time and allocation of the fusing State Estimator's filter: an IMU at 400 Hz, a GPS at 10 Hz, a compass at 50 Hz,
 * all in time; then the same with a GPS that is late by 0.2 s, so that 80 inertial measurements are fused again at each fix.
 */
final class EstimatorCycle {
  private static final long STEP_MICROS = 2_500;
  private static final int WARM_UP = 60_000;
  private static final int MEASURED = 60_000;

  public static void main(String[] args) {
    run("in time", 0);
    run("GPS late by 0.2 s", 200_000);
  }

  private static void run(String name, long lateMicros) {
    com.sun.management.ThreadMXBean thread = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
    Random random = new Random(1);
    Measurement m = new Measurement();
    long[] nanos = new long[MEASURED];
    long bytes = 0;
    long micros = 1_000_000_000L;
    long allocated = 0;
    for (int i = 0; i < WARM_UP + MEASURED; i++) {
      micros += STEP_MICROS;
      if (i == WARM_UP) {
        allocated = thread.getThreadAllocatedBytes(Thread.currentThread().getId());
      }
      long began = thread.getCurrentThreadCpuTime();
      m.begin("IMU", micros)
          .bodyRates(noise(random, 0.01), noise(random, 0.01), noise(random, 0.01), 0.01)
          .specificForce(noise(random, 0.2), noise(random, 0.2), noise(random, 0.2) - 9.8, 0.2);
      filter.add(m);
      if (i % 8 == 0) {
        filter.add(m.begin("Compass", micros).heading(1.0 + noise(random, 0.03), 0.03));
      }
      if (i % 40 == 0) {
        m.begin("GPS", micros - lateMicros)
            .place(29.0 + noise(random, 1e-6), -81.0 + noise(random, 1e-6), 0.5, 0.5)
            .altitude(10.0 + noise(random, 0.5), 0.5)
            .velocity(noise(random, 0.1), noise(random, 0.1), noise(random, 0.1), 0.1);
        filter.add(m);
      }
      filter.resets(); // fuses what was added
      if (i >= WARM_UP) {
        nanos[i - WARM_UP] = thread.getCurrentThreadCpuTime() - began;
      }
    }
    bytes = thread.getThreadAllocatedBytes(Thread.currentThread().getId()) - allocated;
    Arrays.sort(nanos);
    System.out.printf(
        Locale.ROOT,
        "estimator, %s: mean %.1f µs, p50 %.1f µs, p99 %.1f µs a step of 2.5 ms; %.2f bytes allocated a step%n",
        name,
        Arrays.stream(nanos).sum() / 1e3 / MEASURED,
        nanos[MEASURED / 2] / 1e3,
        nanos[MEASURED * 99 / 100] / 1e3,
        bytes / (double) MEASURED);
  }

  private static double noise(Random random, double sigma) {
    return sigma * random.nextGaussian();
  }
}
