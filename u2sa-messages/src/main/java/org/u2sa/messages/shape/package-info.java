/**
 * Objects with an extent: shapes and point clouds, and distances to them. The base class is in
 * {@code messages}.
 */
package org.u2sa.messages.shape;
