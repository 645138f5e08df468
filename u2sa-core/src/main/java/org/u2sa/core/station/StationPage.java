package org.u2sa.core.station;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.core.communication.web.WebSite;

/** The files of the operator's page, from the resources of this module, which phones also carry. */
public final class StationPage implements WebSite {
  private static final String PAGE = "index.html";
  private static final int PART_BYTES = 8_192;

  private static final List<String> NAMES =
      List.of(
          PAGE,
          "style.css",
          "icon.svg",
          "app.js",
          "budget.js",
          "canvas.js",
          "cbor.js",
          "chart.js",
          "coast.js",
          "configuration.js",
          "dom.js",
          "editor.js",
          "fence.js",
          "goalform.js",
          "goals.js",
          "graph.js",
          "insight.js",
          "land.json",
          "layers.js",
          "link.js",
          "map.js",
          "maptools.js",
          "missionlinks.js",
          "missiontab.js",
          "model.js",
          "mqtt.js",
          "orders.js",
          "outline.js",
          "panel.js",
          "place.js",
          "playback.js",
          "series.js",
          "sound.js",
          "services.js",
          "texts.js",
          "tiles.js",
          "xml.js");

  private static final Map<String, String> MEDIA_TYPES =
      Map.of(
          "html", "text/html; charset=utf-8",
          "css", "text/css; charset=utf-8",
          "json", "application/json",
          "js", "text/javascript; charset=utf-8",
          "svg", "image/svg+xml");

  private static final String START = "<html lang=\"en\"";

  private final boolean isRecording;

  /** The page of a vehicle. */
  public StationPage() {
    this(false);
  }

  private StationPage(boolean isRecording) {
    this.isRecording = isRecording;
  }

  /** The page of a recording, which has a timeline instead of orders. */
  public static StationPage ofRecording() {
    return new StationPage(true);
  }

  @Override
  public Map<String, File> files() {
    Map<String, File> files = new HashMap<>();
    for (String name : NAMES) {
      String mediaType = MEDIA_TYPES.get(name.substring(name.lastIndexOf('.') + 1));
      files.put(name.equals(PAGE) ? "/" : "/" + name, new File(mediaType, read(name)));
    }
    if (isRecording) {
      File page = files.get("/");
      String text = new String(page.content(), StandardCharsets.UTF_8);
      String marked = text.replace(START, START + " data-shows=\"recording\"");
      files.put("/", new File(page.mediaType(), marked.getBytes(StandardCharsets.UTF_8)));
    }
    return files;
  }

  private static byte[] read(String name) {
    try (InputStream in = StationPage.class.getResourceAsStream("page/" + name)) {
      if (in == null) {
        throw new IllegalStateException("the page lacks its file " + name);
      }
      ByteArrayOutputStream content = new ByteArrayOutputStream();
      byte[] part = new byte[PART_BYTES];
      for (int count = in.read(part); count >= 0; count = in.read(part)) {
        content.write(part, 0, count);
      }
      return content.toByteArray();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
