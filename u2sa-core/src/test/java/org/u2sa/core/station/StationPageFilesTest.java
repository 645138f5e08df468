package org.u2sa.core.station;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.core.communication.web.WebSite;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.testkit.FreePort;

/** The files of the operator's page, and that they are served. */
class StationPageFilesTest {
  private static final int MAX_BYTES = 250_000; // compressed
  private static final Pattern REFERENCE =
      Pattern.compile("(?:from '\\.|fetch\\('|(?:src|href)=\")(/[^'\"]*)['\"]");

  private final Map<String, WebSite.File> files = new StationPage().files();

  @Test
  void files_referToEachOtherAndToNothingElse() {
    Set<String> referred = new TreeSet<>(Set.of("/"));
    files.forEach(
        (path, file) -> {
          String text = new String(file.content(), UTF_8);
          Matcher matcher = REFERENCE.matcher(text);
          while (matcher.find()) {
            referred.add(matcher.group(1));
          }
          if (!path.endsWith(".svg")) { // its namespace is an address
            assertThat(text).as(path).doesNotContainPattern("(https?:)?//[a-z0-9]+\\.[a-z]");
          }
        });

    assertThat(referred).isEqualTo(new TreeSet<>(files.keySet()));
  }

  @Test
  void ofRecording_page_isMarkedAndThatOfAVehicleIsNot() {
    String mark = "data-shows=\"recording\"";
    String recording = new String(StationPage.ofRecording().files().get("/").content(), UTF_8);
    assertThat(recording).contains(mark);
    assertThat(new String(files.get("/").content(), UTF_8)).doesNotContain(mark);
  }

  @Test
  void scripts_neverMakeMarkupOrCodeOfTexts() {
    files.forEach(
        (path, file) ->
            assertThat(new String(file.content(), UTF_8))
                .as(path)
                .doesNotContainPattern(
                    "(inner|outer)HTML\\s*=[^=]|insertAdjacentHTML|document\\.write|\\beval\\(|new"
                        + " Function|\\son[a-z]+=\"|style=\"|localStorage|sessionStorage|cookie"));
  }

  @Test
  void files_compressed_areSmall() throws IOException {
    int bytes = 0;
    for (WebSite.File file : files.values()) {
      ByteArrayOutputStream zipped = new ByteArrayOutputStream();
      try (GZIPOutputStream out = new GZIPOutputStream(zipped)) {
        out.write(file.content());
      }
      bytes += zipped.size();
    }
    assertThat(bytes).isLessThan(MAX_BYTES);
  }

  @Test
  void start_withAWebPort_servesThePageAndTellsWhere() throws IOException {
    int port = FreePort.find();
    List<String> log = new CopyOnWriteArrayList<>();
    XmlConfiguration configuration =
        XmlConfiguration.inMemory(
            "test", Map.of("COMMUNICATION MANAGER PORT", FreePort.find(), "WEB PORT", port));

    try (CommunicationManager manager =
        CommunicationManager.start("boat", configuration, StandardTypes.registry(), log::add)) {
      assertThat(manager.address()).isPresent();
      assertThat(log)
          .anyMatch(line -> line.startsWith("Operator's page: http://127.0.0.1:" + port))
          .anyMatch(line -> Files.exists(Path.of(line.substring(line.lastIndexOf(' ') + 1))));
      URL page = URI.create("http://127.0.0.1:" + port + "/").toURL();
      try (InputStream in = page.openStream()) {
        assertThat(in.readAllBytes()).isEqualTo(files.get("/").content());
      }
    }
  }
}
