"""The motion as others compute it, and a judge with more digits than all of them."""
