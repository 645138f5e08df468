package org.u2sa.android.sensor

import kotlin.math.asin
import kotlin.math.atan2
import kotlin.math.sqrt
import org.u2sa.messages.frame.Point

private const val FULL_TURN_RAD = 2.0 * Math.PI

/**
 * Orientation of the phone from Android's rotation vector: a unit quaternion from phone axes (x right, y top, z out of the
 * screen) to east, magnetic north, up.
 *
 * @property measuredAtMicros measurement time [µs, run's clock]
 * @property headingSigmaRad standard deviation of the heading [rad]; null if unknown
 */
class PhoneOrientation private constructor(
    val measuredAtMicros: Long,
    private val w: Double,
    private val x: Double,
    private val y: Double,
    private val z: Double,
    val headingSigmaRad: Double?,
) {
    /** The vehicle's roll (right wing down), pitch (nose up) and heading clockwise from magnetic north, 0…2π [rad]. */
    class Attitude(val phi: Double, val theta: Double, val psi: Double)

    /** Rotates a vector from phone axes to east, magnetic north, up. */
    fun toEnu(v: Point): Point {
        // v + 2 q × (q × v + w v), the rotation of a vector by a unit quaternion
        val tx = 2.0 * (y * v.z() - z * v.y())
        val ty = 2.0 * (z * v.x() - x * v.z())
        val tz = 2.0 * (x * v.y() - y * v.x())
        return Point.of(
            v.x() + w * tx + y * tz - z * ty,
            v.y() + w * ty + z * tx - x * tz,
            v.z() + w * tz + x * ty - y * tx,
        )
    }

    /** Attitude of the vehicle for a mounting of the phone. */
    fun attitude(mounting: Mounting): Attitude {
        val forward = toEnu(mounting.forward)
        val right = toEnu(mounting.right)
        val down = toEnu(mounting.down)
        val heading = atan2(forward.x(), forward.y())
        return Attitude(
            phi = atan2(-right.z(), -down.z()),
            theta = asin(forward.z().coerceIn(-1.0, 1.0)),
            psi = if (heading < 0.0) heading + FULL_TURN_RAD else heading,
        )
    }

    companion object {
        /**
         * Parses Android's rotation vector: x, y, z of the quaternion, optionally w, optionally the heading accuracy [rad, -1
         * if unknown, from some phones 0].
         *
         * @return null if values are not finite, as some phones send initially
         */
        fun of(measuredAtMicros: Long, values: FloatArray): PhoneOrientation? {
            if (values.size < 3 || values.any { !it.isFinite() }) {
                return null
            }
            val (x, y, z) = values.map(Float::toDouble)
            val w = if (values.size > 3) values[3].toDouble() else sqrt(maxOf(0.0, 1.0 - x * x - y * y - z * z))
            val length = sqrt(w * w + x * x + y * y + z * z)
            if (length < 0.5) {
                return null
            }
            val sigma = if (values.size > 4 && values[4] > 0.0f) values[4].toDouble() else null
            return PhoneOrientation(measuredAtMicros, w / length, x / length, y / length, z / length, sigma)
        }
    }
}

/** Mounting of the phone: which of its axes point forward, right and down. */
enum class Mounting(val forward: Point, val right: Point, val down: Point) {
    /** Flat on its back, top edge forward. */
    FLAT(Point.of(0.0, 1.0, 0.0), Point.of(1.0, 0.0, 0.0), Point.of(0.0, 0.0, -1.0)),

    /** Upright (portrait), rear camera forward. */
    UPRIGHT(Point.of(0.0, 0.0, -1.0), Point.of(1.0, 0.0, 0.0), Point.of(0.0, -1.0, 0.0)),

    /** On its right side (landscape), top edge to the left, rear camera forward. */
    SIDEWAYS(Point.of(0.0, 0.0, -1.0), Point.of(0.0, -1.0, 0.0), Point.of(-1.0, 0.0, 0.0)),
}
