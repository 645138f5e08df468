package org.u2sa.report.export;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.ByteString;
import org.u2sa.messages.safety.EmergencyStop;

class CsvColumnsTest {
  @Test
  void row_bytes_areBase64() {
    CameraImage image =
        new CameraImage()
            .sensorName("Camera")
            .format(CameraImage.JPEG)
            .size(2, 1)
            .data(ByteString.copyOf(new byte[] {(byte) 0xff, (byte) 0xd8, 0}));
    CsvColumns columns = new CsvColumns();
    columns.learn(image);

    assertThat(columns.head())
        .isEqualTo("time [s],sensorName,format,width [px],height [px],data\r\n");
    assertThat(columns.row(1.5, image)).isEqualTo("1.500000,Camera,jpeg,2,1,/9gA\r\n");
  }

  @Test
  void row_textThatASpreadsheetWouldEvaluate_isMarkedAsText() {
    EmergencyStop stop =
        new EmergencyStop()
            .active(true)
            .stopId("-1")
            .operator("=HYPERLINK(\"http://x\")")
            .reason("a = b");
    CsvColumns columns = new CsvColumns();
    columns.learn(stop);

    assertThat(columns.row(0.0, stop))
        .contains(",'-1\r", "\"'=HYPERLINK(\"\"http://x\"\")\"", "a = b");
  }

  @Test
  void row_negativeNumber_staysANumber() {
    StateInformation state = new StateInformation().sensorName("GPS").x(-0.5);
    CsvColumns columns = new CsvColumns();
    columns.learn(state);

    assertThat(columns.row(0.0, state)).contains(",-0.5").doesNotContain("'");
  }
}
