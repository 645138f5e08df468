package org.u2sa.core.communication.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.netty.handler.codec.http.DefaultFullHttpRequest;
import io.netty.handler.codec.http.FullHttpResponse;
import io.netty.handler.codec.http.HttpMethod;
import io.netty.handler.codec.http.HttpVersion;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.DiskThread;

/** Ranges of a file of tiles. */
class WebTilesTest {
  private static final int SIZE = 2_000_000;

  @TempDir private Path folder;
  private final DiskThread disk = new DiskThread("test");
  private WebTiles tiles;

  @BeforeEach
  void open() throws IOException {
    byte[] content = new byte[SIZE];
    byte[] start = "PMTiles\u0003abcdef".getBytes(StandardCharsets.US_ASCII);
    System.arraycopy(start, 0, content, 0, start.length);
    content[SIZE - 1] = 'z';
    tiles = WebTiles.open(Files.write(folder.resolve("map.pmtiles"), content), disk);
  }

  private FullHttpResponse answer(String range) {
    return ask(range).orTimeout(60, TimeUnit.SECONDS).join();
  }

  private CompletableFuture<FullHttpResponse> ask(String range) {
    DefaultFullHttpRequest request =
        new DefaultFullHttpRequest(HttpVersion.HTTP_1_1, HttpMethod.GET, WebTiles.PATH);
    request.headers().set("Range", range);
    CompletableFuture<FullHttpResponse> answer = new CompletableFuture<>();
    tiles.answer(request, answer::complete);
    return answer;
  }

  @ParameterizedTest
  @CsvSource({
    "bytes=8-10, abc, bytes 8-10/2000000",
    "bytes=1999999-2500000, z, bytes 1999999-1999999/2000000",
  })
  void answer_oneRange_isIt(String range, String content, String said) {
    FullHttpResponse response = answer(range);

    assertThat(response.status().code()).isEqualTo(206);
    assertThat(response.content().toString(StandardCharsets.US_ASCII)).isEqualTo(content);
    assertThat(response.headers().get("Content-Range")).isEqualTo(said);
    assertThat(response.headers().contains("Content-Security-Policy")).isTrue();
  }

  @ParameterizedTest
  @CsvSource(
      value = {
        "bytes=0-1048576|longer than 1 MiB",
        "bytes=10-9|backwards",
        "bytes=2000000-2000001|behind the end",
        "bytes=0-1,5-6|two ranges",
        "bytes=-5|a suffix",
        "bytes=0-|without an end",
        "bytes=0-99999999999999999999|no number",
        "''|none",
      },
      delimiter = '|')
  void answer_otherRanges_areRefused(String range, String why) {
    assertThat(answer(range).status().code()).as(why).isEqualTo(416);
  }

  @Test
  void answer_manyRangesThatNobodyReads_takeBoundedMemory() {
    int sent = 0;
    while (sent < 100 && answer("bytes=0-1048575").status().code() == 206) {
      sent++;
    }
    assertThat(sent).isBetween(1, 16);
    assertThat(answer("bytes=0-1048575").status().code()).isEqualTo(503);

    tiles.sent(WebTiles.LONGEST_RANGE);
    assertThat(answer("bytes=0-1048575").status().code()).isEqualTo(206);
  }

  @Test
  void answer_diskHangs_doesNotWaitAndRefusesWhatIsTooMuch() {
    CompletableFuture<String> answers = new CompletableFuture<>();
    disk.execute(answers::join);
    List<CompletableFuture<FullHttpResponse>> asked = new ArrayList<>();
    for (int i = 0; i < WebTiles.MAX_WAITING; i++) {
      asked.add(ask("bytes=8-10"));
    }

    assertThat(asked).noneMatch(CompletableFuture::isDone);
    assertThat(answer("bytes=8-10").status().code()).isEqualTo(503);

    answers.complete("now");
    assertThat(asked)
        .allMatch(each -> each.orTimeout(60, TimeUnit.SECONDS).join().status().code() == 206);
    assertThat(answer("bytes=8-10").status().code()).isEqualTo(206);
  }

  @Test
  void open_anotherFile_isRefusedByName() throws IOException {
    Path other = Files.write(folder.resolve("map.mbtiles"), Arrays.copyOf(new byte[0], 20));

    assertThatThrownBy(() -> WebTiles.open(other))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith("WEB TILES: " + other + ": not PMTiles version 3");
    assertThatThrownBy(() -> WebTiles.open(folder.resolve("none")))
        .hasMessageContaining("no such file");
  }
}
