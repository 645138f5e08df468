package org.u2sa.spark;

import java.io.IOException;
import java.io.PrintStream;
import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;
import java.util.stream.IntStream;
import org.apache.spark.SparkConf;
import org.apache.spark.TaskContext;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import scala.Function2;
import scala.collection.Iterator;
import scala.jdk.javaapi.CollectionConverters;
import scala.reflect.ClassTag;
import scala.runtime.BoxedUnit;

/**
 * Spark driver process of {@link SparkRuns}, the only one with Spark's classes: one task per line
 * of the request file. Each line of standard output is a request number, from 0, a blank and its
 * answer, in order of completion. The last line is {@value #ALL_DONE}, or {@value #TROUBLE} and an
 * error message.
 */
final class SparkDriver {
  static final String ALL_DONE = "done";
  static final String TROUBLE = "trouble ";

  private SparkDriver() {}

  /**
   * @param arguments file of requests and file of the workers' JVM options, one per line
   */
  public static void main(String[] arguments) throws IOException {
    ProcessHandle.current()
        .parent()
        .ifPresent(parent -> parent.onExit().thenRun(() -> Runtime.getRuntime().halt(1)));
    PrintStream answers = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    System.setOut(System.err); // stdout is for answers only
    List<String> requests = Files.readAllLines(Path.of(arguments[0]));
    List<String> javaOptions = Files.readAllLines(Path.of(arguments[1]));
    try (JavaSparkContext spark = new JavaSparkContext(configuration())) {
      ExecutorsJoined.await(spark);
      run(spark, requests, spark.broadcast(new ExecutorWorkers(javaOptions)), answers);
      answers.println(ALL_DONE);
    } catch (RuntimeException e) {
      e.printStackTrace();
      answers.println(TROUBLE + String.valueOf(e.getMessage()).lines().findFirst().orElse(""));
    }
  }

  /** Options of the command line, and the file's settings that they leave open. */
  private static SparkConf configuration() throws IOException {
    SparkConf configuration = new SparkConf();
    Properties settings = ClusterProperties.read(ClusterProperties.file(System.getenv()));
    for (String name : settings.stringPropertyNames()) {
      if (name.startsWith("spark.")) {
        configuration.setIfMissing(name, settings.getProperty(name).trim());
      }
    }
    return configuration;
  }

  private static void run(
      JavaSparkContext spark,
      List<String> requests,
      Broadcast<ExecutorWorkers> workers,
      PrintStream answers) {
    @SuppressWarnings("unchecked")
    Function2<TaskContext, Iterator<String>, String> task =
        (Function2<TaskContext, Iterator<String>, String> & Serializable)
            (context, requested) -> answer(workers.value(), requested.next());
    spark
        .sc()
        .runJob(
            spark.parallelize(requests, requests.size()).rdd(),
            task,
            CollectionConverters.asScala(
                    IntStream.range(0, requests.size()).<Object>mapToObj(i -> i).toList())
                .toSeq(),
            (number, answer) -> {
              answers.println(number + " " + answer);
              return BoxedUnit.UNIT;
            },
            ClassTag.apply(String.class));
  }

  private static String answer(ExecutorWorkers workers, String request) {
    try {
      return workers.call(request);
    } catch (IOException e) {
      throw new IllegalStateException(
          "a process for runs could not be started: " + e.getMessage(), e);
    }
  }
}
