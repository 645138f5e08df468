package org.u2sa.android.sensor

import kotlin.math.asin
import kotlin.math.atan2
import kotlin.math.sqrt
import org.u2sa.messages.frame.Point

private const val FULL_TURN_RAD = 2.0 * Math.PI

/**
 * How the phone lay at one moment, as Android's rotation vector says it: a unit quaternion that turns the phone's axes (x to
 * the right of its screen, y to its top, z out of it) into east, magnetic north and up.
 *
 * @property measuredAtMicros when [µs of the run's clock]
 * @property headingSigmaRad standard deviation of the heading [rad]; null if Android does not say
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

    /** A vector of the phone's axes in east, magnetic north and up. */
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

    /** The attitude of a vehicle that carries the phone like this. */
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
         * Reads Android's rotation vector: x, y, z of the quaternion, then perhaps w, then perhaps the heading's accuracy
         * [rad, -1 if unknown].
         *
         * @return null if these are no numbers, as a few phones send them at first
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
            val sigma = if (values.size > 4 && values[4] >= 0.0f) values[4].toDouble() else null
            return PhoneOrientation(measuredAtMicros, w / length, x / length, y / length, z / length, sigma)
        }
    }
}

/** How the phone is fixed to the vehicle: which of the phone's axes point forward, right and down. */
enum class Mounting(val forward: Point, val right: Point, val down: Point) {
    /** Lies on its back, top edge forward. */
    FLAT(Point.of(0.0, 1.0, 0.0), Point.of(1.0, 0.0, 0.0), Point.of(0.0, 0.0, -1.0)),

    /** Stands upright, its camera looks forward. */
    UPRIGHT(Point.of(0.0, 0.0, -1.0), Point.of(1.0, 0.0, 0.0), Point.of(0.0, -1.0, 0.0)),

    /** Lies on its right-hand side, top edge to the left, its camera looks forward. */
    SIDEWAYS(Point.of(0.0, 0.0, -1.0), Point.of(0.0, -1.0, 0.0), Point.of(-1.0, 0.0, 0.0)),
}
