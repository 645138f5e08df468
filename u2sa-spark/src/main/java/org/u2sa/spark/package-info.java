/**
 * Campaigns on Apache Spark: {@link org.u2sa.spark.SparkRuns} starts a process with Spark's
 * classes, {@link org.u2sa.spark.SparkDriver}, whose tasks hand each run to processes of this
 * program. Runs themselves never see Spark's classes, nor does this program.
 */
package org.u2sa.spark;
