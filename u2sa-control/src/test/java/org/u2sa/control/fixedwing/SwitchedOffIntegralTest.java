package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.control.Transfer;
import org.u2sa.service.handover.HandOver;

class SwitchedOffIntegralTest {
  @Test
  void step_rateLoopWithoutIntegral_keepsNoneOfAnother() {
    RateLoop loop = new RateLoop("", new RateLoop.Gains(0.5, 0.2, 0.0, 0.6));

    loop.restart(0.4); // what a loop with an integral hands over

    assertThat(loop.step(0.0, 0.0, 1.0, 0.02)).isZero();
  }

  @Test
  void restart_yawLawWithoutIntegral_keepsNoneOfAnother() {
    YawLaw law = new YawLaw(new YawLaw.Variables(0.5, 0.8, 0.0, 0.5, 0.45));
    HandOver state = new HandOver("test");

    law.restart(0.4);
    law.transfer(Transfer.saving(state));

    assertThat(state.number("YAW INTEGRAL")).hasValue(0.0);
  }
}
