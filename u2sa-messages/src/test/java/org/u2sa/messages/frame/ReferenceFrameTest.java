package org.u2sa.messages.frame;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ReferenceFrameTest {
  @ParameterizedTest
  @CsvSource({
    "Global,GLOBAL",
    "local enu,LOCAL_ENU",
    "LOCAL-NED,LOCAL_NED",
    " body ,BODY",
    "Body_FRD,BODY_FRD",
    "body flu,BODY_FLU",
    "utm 4n,UTM 4N",
    "UTM60S,UTM 60S",
    "UTM 04 N,UTM 4N"
  })
  void parse_namesInAnyCase_areTheFrames(String text, String name) {
    ReferenceFrame frame = ReferenceFrame.parse(text);

    assertThat(frame.name()).isEqualTo(name);
    assertThat(ReferenceFrame.parse(frame.name())).isEqualTo(frame).hasSameHashCodeAs(frame);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "Mars", "UTM", "UTM 4", "UTM N", "UTM 444N", "LOCAL"})
  void parse_unknownName_saysWhatIsExpected(String text) {
    assertThatThrownBy(() -> ReferenceFrame.parse(text))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageStartingWith("\"" + text + "\" is not a reference frame; expected GLOBAL")
        .hasMessageContaining("UTM <zone><N|S>");
  }

  @Test
  void utm_zoneOutside1to60_isRefused() {
    assertThatThrownBy(() -> ReferenceFrame.utm(0, true)).hasMessage("UTM zone: 0 is outside 1…60");
    assertThatThrownBy(() -> ReferenceFrame.parse("UTM 61N")).hasMessageContaining("61");
  }

  @Test
  void families_everyFrame_isOfOne() {
    for (String name : new String[] {"GLOBAL", "UTM 4N"}) {
      ReferenceFrame frame = ReferenceFrame.parse(name);
      assertThat(frame.isEarth() && !frame.isLocal() && !frame.isBody()).isTrue();
    }
    assertThat(ReferenceFrame.LOCAL_ENU.isLocal() && !ReferenceFrame.LOCAL_ENU.isEarth()).isTrue();
    assertThat(ReferenceFrame.BODY_FLU.isBody() && !ReferenceFrame.BODY_FLU.isLocal()).isTrue();
    assertThat(ReferenceFrame.utm(4, true)).isNotEqualTo(ReferenceFrame.utm(4, false));
  }
}
