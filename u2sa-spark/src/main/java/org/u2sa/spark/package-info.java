/**
 * Campaigns on Apache Spark: {@link org.u2sa.spark.SparkRuns} starts a process with Spark's
 * classes, {@link org.u2sa.spark.SparkDriver}, whose tasks pass each run to processes of this
 * program. Neither the runs nor this program have Spark on their class path.
 */
package org.u2sa.spark;
