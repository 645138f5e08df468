package org.u2sa.scenarios.igvc;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.sim.device.SimulatedLaser;
import org.u2sa.sim.ground.DrivingHazard;
import org.u2sa.sim.sensor.NoiseStreams;

class HardnessTest {
  private static final Course COURSE = CourseGenerator.course(1);

  private static List<DrivingHazard> of(Set<Hardness> chosen, long seed) {
    return Hardness.hazards(chosen, COURSE, new NoiseStreams(seed)).all();
  }

  @Test
  void hazards_noneChosen_nothingGoesWrong() {
    assertThat(of(Set.of(), 1L)).isEmpty();
    assertThat(Hardness.laser(Set.of())).isEqualTo(SimulatedLaser.Faults.NONE);
  }

  @Test
  void hazards_eachKind_isItsOwnAndOfTheSeed() {
    assertThat(of(EnumSet.of(Hardness.MULTIPATH), 1L))
        .hasSize(8)
        .hasOnlyElementsOfType(DrivingHazard.Multipath.class)
        .isEqualTo(of(EnumSet.of(Hardness.MULTIPATH), 1L))
        .isNotEqualTo(of(EnumSet.of(Hardness.MULTIPATH), 2L));
    assertThat(of(EnumSet.of(Hardness.SLIP), 1L))
        .hasOnlyElementsOfType(DrivingHazard.Slippery.class);
    assertThat(of(EnumSet.of(Hardness.COMPASS), 1L))
        .hasOnlyElementsOfType(DrivingHazard.Magnetic.class);
  }

  @Test
  void hazards_anotherKindAsWell_leavesTheFirstAsItWas() {
    assertThat(of(EnumSet.allOf(Hardness.class), 1L))
        .containsAll(of(EnumSet.of(Hardness.SLIP), 1L))
        .containsAll(of(EnumSet.of(Hardness.MULTIPATH), 1L));
  }

  @Test
  void laser_mixedPixels_hasFaults() {
    assertThat(Hardness.laser(EnumSet.of(Hardness.MIXED_PIXELS)).mixed()).isPositive();
  }
}
