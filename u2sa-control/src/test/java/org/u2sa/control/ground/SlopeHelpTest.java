package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.StateInformation;

class SlopeHelpTest {
  private final SlopeHelp help = new SlopeHelp(450.0);

  private static StateInformation pitched(double theta) {
    return new StateInformation().theta(theta);
  }

  @Test
  void share_uphillAndDownhill_isThatOfTheWeight() {
    double slope = Math.atan(0.15);
    assertThat(help.share(pitched(slope))).isCloseTo(4.5 * Math.sin(slope), within(1.0e-12));
    assertThat(help.share(pitched(-slope))).isCloseTo(-4.5 * Math.sin(slope), within(1.0e-12));
  }

  @Test
  void share_pitchOfALawnOrNone_isNone() {
    assertThat(help.share(pitched(0.025))).isZero();
    assertThat(help.share(new StateInformation())).isZero();
    assertThat(new SlopeHelp(0.0).share(pitched(0.2))).isZero();
  }
}
