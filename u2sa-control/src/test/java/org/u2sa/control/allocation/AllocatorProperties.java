package org.u2sa.control.allocation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;

class AllocatorProperties {
  private static final double SLACK = 1e-9;

  private static Effector random(Random random, int number) {
    Point force = point(random, 50.0);
    Point place = point(random, 0.5);
    return Effector.of(
            new ActuatorAnnouncement()
                .actuatorName("T" + number)
                .minimum(random.nextBoolean() ? -100.0 : 0.0)
                .maximum(100.0)
                .force(force)
                .moment(
                    Point.of(
                        place.y() * force.z() - place.z() * force.y(),
                        place.z() * force.x() - place.x() * force.z(),
                        place.x() * force.y() - place.y() * force.x()))
                .renewal(0.25))
        .orElseThrow();
  }

  /** Mostly along one axis, so that what is left often reaches an axis by chance only. */
  private static Point point(Random random, double size) {
    double[] along = new double[3];
    for (int i = 0; i < along.length; i++) {
      along[i] = 0.01 * size * random.nextGaussian();
    }
    along[random.nextInt(along.length)] += size * (random.nextBoolean() ? 1.0 : -1.0);
    return Point.of(along[0], along[1], along[2]);
  }

  /** Of a wrench that misses the wanted one: each axis by what the sound vehicle could do. */
  private static double error(double[] weights, double[] scales, double[] missing) {
    double sum = 0.0;
    for (int j = 0; j < missing.length; j++) {
      if (scales[j] > 0.0) {
        sum += Math.pow(weights[j] * missing[j] / scales[j], 2);
      }
    }
    return sum;
  }

  @Property(tries = 500)
  void allocate_someEffectorsLost_isNeverWorseThanDoingNothing(
      @ForAll long seed, @IntRange(min = 2, max = 8) @ForAll int count) {
    Random random = new Random(seed);
    List<Effector> sound = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      sound.add(random(random, i));
    }
    List<Effector> left = new ArrayList<>(sound);
    left.removeIf(each -> random.nextInt(3) == 0);
    double[] weights = random.doubles(DegreeOfFreedom.COUNT, 0.1, 3.0).toArray();
    double[] wanted = random.doubles(DegreeOfFreedom.COUNT, -60.0, 60.0).toArray();
    Allocator whole = new Allocator(weights);
    whole.use(sound, each -> 1.0);
    whole.allocate(wanted, 0.0, Double.NaN);
    double[] scales = new double[DegreeOfFreedom.COUNT];
    Allocator allocator = new Allocator(weights);
    allocator.use(left, sound, each -> 1.0);

    allocator.allocate(wanted, 0.0, Double.NaN);

    double[] missing = new double[DegreeOfFreedom.COUNT];
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      int j = axis.ordinal();
      scales[j] = whole.reference(axis);
      missing[j] = wanted[j] - allocator.attained(axis);
    }
    double before = error(weights, scales, wanted);
    assertThat(error(weights, scales, missing)).isLessThanOrEqualTo(before * (1.0 + SLACK));
  }
}
