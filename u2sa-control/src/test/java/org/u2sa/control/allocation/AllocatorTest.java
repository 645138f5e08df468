package org.u2sa.control.allocation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;

class AllocatorTest {
  private static final double[] ALL_AXES_BUT_PITCH = {1.0, 1.0, 1.0, 1.0, 0.0, 1.0};

  private static Allocator of(List<Effector> effectors) {
    Allocator allocator = new Allocator(ALL_AXES_BUT_PITCH);
    allocator.use(effectors, each -> 1.0);
    return allocator;
  }

  private static double share(Allocator allocator, int index) {
    return allocator.effectors().get(index).share(allocator.percent(index));
  }

  @Test
  void allocate_withinTheLimits_isThePseudoInverse() {
    List<Effector> effectors = SixThrusters.effectors();
    Allocator allocator = of(effectors);
    double[] wanted = {20.0, -8.0, 12.0, 0.5, 0.0, 2.0};
    DegreeOfFreedom[] axes =
        Arrays.stream(DegreeOfFreedom.values())
            .filter(axis -> axis != DegreeOfFreedom.PITCH)
            .toArray(DegreeOfFreedom[]::new);
    double[][] squares = new double[axes.length][axes.length];
    double[] right = new double[axes.length];
    for (int j = 0; j < axes.length; j++) {
      right[j] = wanted[axes[j].ordinal()];
      for (int k = 0; k < axes.length; k++) {
        for (Effector each : effectors) {
          squares[j][k] += each.effect(axes[j]) * each.effect(axes[k]);
        }
      }
    }
    double[] lambda = Gauss.solve(squares, right);

    allocator.allocate(wanted, 0.0, Double.NaN);

    for (int i = 0; i < 6; i++) {
      double expected = 0.0; // of Bᵀ (B Bᵀ)⁻¹ τ
      for (int j = 0; j < axes.length; j++) {
        expected += effectors.get(i).effect(axes[j]) * lambda[j];
      }
      assertThat(share(allocator, i)).isCloseTo(expected, within(1e-3));
    }
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      if (axis != DegreeOfFreedom.PITCH) {
        assertThat(allocator.attained(axis)).isCloseTo(wanted[axis.ordinal()], within(1e-3));
      }
    }
  }

  /** Against scipy.optimize.lsq_linear (1.17.1, bvls) of the same problem. */
  @Test
  void allocate_moreThanThereIs_isTheSolutionOfAnotherSolver() {
    assertShares(
        new Allocator(1, 1, 1, 1, 0, 3),
        "",
        new double[] {200.0, 50.0, 30.0, 1.0, 0.0, 9.0},
        0.154245152,
        1.0,
        1.0,
        1.0,
        0.488635386,
        0.261363114);
    assertShares(
        new Allocator(1, 2, 1, 1, 0, 3),
        "T1",
        new double[] {40.0, -30.0, 90.0, 2.0, 0.0, -6.0},
        -0.75,
        0.94590169,
        1.0,
        1.0,
        0.897725477);
  }

  private static void assertShares(
      Allocator allocator, String lost, double[] wanted, double... expected) {
    List<Effector> effectors = new ArrayList<>(SixThrusters.effectors());
    effectors.removeIf(each -> each.name().equals(lost));
    Map<String, Double> costs =
        lost.isEmpty() ? Map.of() : Map.of("T3", 2.0, "T5", 4.0); // as in the other solver
    allocator.use(effectors, each -> costs.getOrDefault(each.name(), 1.0));

    allocator.allocate(wanted, 0.0, Double.NaN);

    for (int i = 0; i < expected.length; i++) {
      assertThat(share(allocator, i)).isCloseTo(expected[i], within(1e-6));
    }
  }

  /** A thruster of 40 N each way, turned to the right of the bow [deg]. */
  private static Effector thruster(String name, double newtons, double turnedDeg) {
    double turned = Math.toRadians(turnedDeg);
    Point force = Point.of(newtons * Math.cos(turned), newtons * Math.sin(turned), 0.0);
    return Effector.of(
            new ActuatorAnnouncement()
                .actuatorName(name)
                .minimum(-100.0)
                .maximum(100.0)
                .force(force)
                .moment(Point.ORIGIN)
                .renewal(0.25))
        .orElseThrow();
  }

  private static final List<Effector> SIDE_THRUSTERS =
      List.of(thruster("BOW", 40.0, 89.5), thruster("STERN", 40.0, 89.5));

  @Test
  void allocate_surgeLost_isNotFoughtForBySway() {
    Allocator allocator = new Allocator(1.0, 1.0, 0.0, 0.0, 0.0, 0.0);
    List<Effector> sound = new ArrayList<>(SIDE_THRUSTERS);
    sound.add(thruster("MAIN", 100.0, 0.0));
    allocator.use(SIDE_THRUSTERS, sound, each -> 1.0);

    allocator.allocate(new double[] {5.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0, Double.NaN);

    assertThat(allocator.attained(DegreeOfFreedom.SWAY)).isCloseTo(0.0, within(0.1));
  }

  @Test
  void allocate_surgeOnlyByMisalignedThrusters_isNotFoughtForBySway() {
    Allocator allocator = new Allocator(1.0, 1.0, 0.0, 0.0, 0.0, 0.0);
    allocator.use(SIDE_THRUSTERS, each -> 1.0); // nobody knows of a main thruster

    allocator.allocate(new double[] {5.0, 30.0, 0.0, 0.0, 0.0, 0.0}, 0.0, Double.NaN);

    assertThat(allocator.attained(DegreeOfFreedom.SWAY)).isCloseTo(30.0, within(0.1));
  }

  @Test
  void allocate_astern_commandsMoreForTheSameForce() {
    Allocator allocator = of(SixThrusters.effectors());

    allocator.allocate(new double[] {0.0, 0.0, 30.0, 0.0, 0.0, 0.0}, 0.0, Double.NaN);
    assertThat(allocator.percent(4)).isCloseTo(100.0 * Math.sqrt(15.0 / 40.0), within(0.01));

    allocator.allocate(new double[] {0.0, 0.0, -30.0, 0.0, 0.0, 0.0}, 0.0, Double.NaN);
    assertThat(allocator.percent(4)).isCloseTo(-100.0 * Math.sqrt(15.0 / 30.0), within(0.01));
  }

  @Test
  void allocate_oneThrusterLost_stillGivesTheWantedWrench() {
    List<Effector> five = new ArrayList<>(SixThrusters.effectors());
    five.remove(0);
    Allocator allocator = of(five);
    double[] wanted = {10.0, -4.0, 12.0, 0.5, 0.0, 2.0};

    allocator.allocate(wanted, 0.0, Double.NaN);

    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      if (axis != DegreeOfFreedom.PITCH) {
        assertThat(allocator.attained(axis)).isCloseTo(wanted[axis.ordinal()], within(1e-3));
      }
    }
  }

  @Test
  void allocate_moreThanThereIs_errsWhereTheWeightIsLeast() {
    Allocator allocator = new Allocator(1.0, 1.0, 1.0, 1.0, 0.0, 30.0);
    allocator.use(SixThrusters.effectors(), each -> 1.0);

    allocator.allocate(new double[] {200.0, 0.0, 0.0, 0.0, 0.0, 5.0}, 0.0, Double.NaN);

    assertThat(allocator.attained(DegreeOfFreedom.YAW)).isCloseTo(5.0, within(0.1));
    assertThat(allocator.attained(DegreeOfFreedom.SURGE)).isBetween(60.0, 113.2);
  }

  @Test
  void allocate_dearEffector_doesLess() {
    Allocator allocator = new Allocator(0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
    allocator.use(SixThrusters.effectors(), each -> each.name().equals("T5") ? 9.0 : 1.0);

    allocator.allocate(new double[] {0.0, 0.0, 20.0, 0.0, 0.0, 0.0}, 0.0, Double.NaN);

    assertThat(share(allocator, 5)).isCloseTo(9.0 * share(allocator, 4), within(1e-3));
  }

  /** A step of 1 % of a propeller is a ten thousandth of its thrust. */
  @ParameterizedTest
  @ValueSource(doubles = {1.0, 2.0, 3.0})
  void allocate_slowActuatorWithACurve_getsThereAheadAndAstern(double exponent) {
    ActuatorAnnouncement slow = push("SLOW").rateLimit(50.0).exponent(exponent).deadband(5.0);
    Allocator allocator = of(List.of(Effector.of(slow).orElseThrow()));
    double wantedN = 0.5 * Effector.of(slow).orElseThrow().effect(DegreeOfFreedom.SURGE);

    for (double sign : new double[] {1.0, -1.0, 1.0}) {
      for (int i = 0; i < 250; i++) {
        allocator.allocate(new double[] {sign * wantedN, 0, 0, 0, 0, 0}, 0.02, Double.NaN);
      }
      assertThat(share(allocator, 0)).isCloseTo(0.5 * sign, within(0.01));
    }
  }

  @Test
  void allocate_rateLimited_movesByNoMoreAndOthersTakeOver() {
    ActuatorAnnouncement slow = push("SLOW").rateLimit(50.0);
    List<Effector> two = new ArrayList<>();
    Effector.of(slow).ifPresent(two::add);
    Effector.of(push("QUICK")).ifPresent(two::add);
    Allocator allocator = new Allocator(1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    allocator.use(two, each -> 1.0);

    allocator.allocate(new double[] {12.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.1, Double.NaN);

    assertThat(allocator.percent(0)).isCloseTo(5.0, within(1e-9));
    assertThat(allocator.percent(1)).isCloseTo(100.0, within(1e-9));
    assertThat(allocator.attained(DegreeOfFreedom.SURGE)).isCloseTo(10.5, within(1e-9));
  }

  @Test
  void allocate_slowWithDeadband_leavesTheDeadband() {
    ActuatorAnnouncement slow = push("SLOW").rateLimit(10.0).deadband(20.0);
    List<Effector> one = new ArrayList<>();
    Effector.of(slow).ifPresent(one::add);
    Allocator allocator = new Allocator(1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    allocator.use(one, each -> 1.0);

    for (int i = 0; i < 10; i++) {
      allocator.allocate(new double[] {10.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.1, Double.NaN);
    }

    assertThat(allocator.percent(0)).isCloseTo(30.0, within(1e-6));
  }

  @Test
  void allocate_controlSurface_countsBySpeedSquared() {
    List<Effector> one = new ArrayList<>();
    Effector.of(push("RUDDER").referenceSpeed(2.0)).ifPresent(one::add);
    Allocator allocator = new Allocator(1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    allocator.use(one, each -> 1.0);

    allocator.allocate(new double[] {2.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 0.0, 1.0);

    assertThat(allocator.percent(0)).isCloseTo(80.0, within(1e-3));
  }

  private static ActuatorAnnouncement push(String name) {
    return new ActuatorAnnouncement()
        .actuatorName(name)
        .minimum(-100.0)
        .maximum(100.0)
        .force(Point.of(10.0, 0.0, 0.0));
  }

  @Test
  void allocate_thousandTimes_makesNoGarbage() {
    Allocator allocator = of(SixThrusters.effectors());
    double[] wanted = {120.0, -30.0, 90.0, 1.0, 0.0, 9.0};
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    allocator.allocate(wanted, 0.02, Double.NaN);
    long id = Thread.currentThread().getId();

    long before = threads.getThreadAllocatedBytes(id);
    for (int i = 0; i < 1000; i++) {
      wanted[5] = i % 7;
      allocator.allocate(wanted, 0.02, Double.NaN);
    }

    assertThat(threads.getThreadAllocatedBytes(id) - before).isLessThan(20_000);
  }

  @Test
  void make_badWeightsOrCosts_isRefused() {
    assertThatThrownBy(() -> new Allocator(1.0, 1.0)).hasMessageContaining("six numbers");
    assertThatThrownBy(() -> new Allocator(1, 1, 1, 1, 1, -1)).hasMessageContaining("six numbers");
    assertThatThrownBy(() -> of(List.of()).use(SixThrusters.effectors(), each -> 0.0))
        .hasMessageContaining("cost of T1");
  }

  @Test
  void effector_withoutEffectInNumbers_isNone() {
    assertThat(
            Effector.of(
                new ActuatorAnnouncement().actuatorName("LAMP").minimum(0.0).maximum(100.0)))
        .isEmpty();
  }
}
