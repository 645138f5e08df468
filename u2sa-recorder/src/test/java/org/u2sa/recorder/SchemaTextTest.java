package org.u2sa.recorder;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.CameraImage;

class SchemaTextTest {
  @Test
  void of_bytes_isTextInBase64() {
    assertThat(SchemaText.of(CameraImage.TYPE))
        .contains("\"data\":{\"type\":\"string\",\"contentEncoding\":\"base64\"}")
        .contains("\"required\":[\"sensorName\",\"format\",\"data\"]");
  }
}
