"""Refuelling in the air and at bases: which vehicle is served next, by which giver, and each service from decision to
end."""
