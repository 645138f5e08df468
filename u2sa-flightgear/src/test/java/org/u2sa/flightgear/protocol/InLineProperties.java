package org.u2sa.flightgear.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Locale;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.assertj.core.data.Offset;
import org.u2sa.sim.aircraft.ControlInputs;

final class InLineProperties {
  private static final ControlInputs SOME =
      new ControlInputs(0.1, -0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8);

  @Example
  void format_controls_inTheProtocolsOrder() {
    assertThat(InLine.nothing().next(SOME).format())
        .isEqualTo("0.100000,-0.200000,0.300000,0.600000,0.400000,0.500000,0.700000,0.800000,1");
  }

  @Example
  void format_machineThatWritesCommasInNumbers_stillWritesPoints() {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.GERMANY);
    try {
      assertThat(InLine.nothing().next(SOME).format()).startsWith("0.100000,-0.200000,");
    } finally {
      Locale.setDefault(before);
    }
  }

  @Property(tries = 200)
  void after_formatted_isTheSame(
      @ForAll @DoubleRange(min = -1, max = 1) double aileron,
      @ForAll @DoubleRange(min = -1, max = 1) double elevator,
      @ForAll @DoubleRange(min = 0, max = 1) double throttle)
      throws MalformedLineException {
    InLine sent =
        InLine.nothing()
            .next(SOME.withSurfaces(aileron, elevator, -aileron).withThrottle(throttle));
    InLine got = InLine.nothing().after(sent.format());
    assertThat(got.controls().aileron()).isCloseTo(aileron, Offset.offset(1e-6));
    assertThat(got.controls().elevator()).isCloseTo(elevator, Offset.offset(1e-6));
    assertThat(got.controls().rudder()).isCloseTo(-aileron, Offset.offset(1e-6));
    assertThat(got.controls().throttle()).isCloseTo(throttle, Offset.offset(1e-6));
    assertThat(got.count()).isEqualTo(sent.count());
  }

  @Property(tries = 300)
  void after_anyText_neverGivesImpossibleControls(@ForAll String text) {
    try {
      assertThat(InLine.nothing().after(text).controls()).isNotNull();
    } catch (MalformedLineException refused) {
      assertThat(refused.getMessage()).endsWith("would corrupt the flight model");
    }
  }

  @Example
  void after_shortLine_setsItsFieldsOnly() throws MalformedLineException {
    InLine got = new InLine(SOME, 7).after("0.9,-0.8");
    assertThat(got.controls()).isEqualTo(SOME.withSurfaces(0.9, -0.8, SOME.rudder()));
    assertThat(got.count()).isEqualTo(7);
  }

  @Example
  void after_garbage_countsAsZero() throws MalformedLineException {
    assertThat(new InLine(SOME, 7).after("x,,0.5").controls())
        .isEqualTo(SOME.withSurfaces(0.0, 0.0, 0.5));
  }

  @Example
  void after_nan_isRefused() {
    for (String text : new String[] {"nan", "-NaN", "inf", "Infinity"}) {
      assertThatThrownBy(() -> InLine.nothing().after("0," + text))
          .isInstanceOf(MalformedLineException.class)
          .hasMessageContaining("/controls/flight/elevator");
    }
  }

  @Example
  void next_lastCount_beginsAgain() {
    assertThat(new InLine(SOME, InLine.LAST_COUNT).next(SOME).count()).isEqualTo(1);
  }
}
