package org.u2sa.android.sensor

import android.hardware.camera2.CameraMetadata
import android.os.SystemClock

private const val NANOS_PER_MICRO = 1_000L
private const val NANOS_PER_MILLI = 1_000_000L

/**
 * Age of a picture by its camera's timestamp clock: time since boot if the camera declares it, otherwise uptime without deep sleep, which may be hours less.
 */
internal class PictureAge(private val clockNanos: () -> Long) {
    fun micros(stampNanos: Long): Long = maxOf(0L, clockNanos() - stampNanos) / NANOS_PER_MICRO

    companion object {
        /**
         * @param source `SENSOR_INFO_TIMESTAMP_SOURCE` of the camera, or null
         */
        fun of(
            source: Int?,
            sinceBootNanos: () -> Long = SystemClock::elapsedRealtimeNanos,
            awakeNanos: () -> Long = { SystemClock.uptimeMillis() * NANOS_PER_MILLI },
        ): PictureAge =
            PictureAge(if (source == CameraMetadata.SENSOR_INFO_TIMESTAMP_SOURCE_REALTIME) sinceBootNanos else awakeNanos)
    }
}
